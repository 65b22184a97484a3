//! Packs meshes.
