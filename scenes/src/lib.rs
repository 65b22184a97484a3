//! The scenes.
#![no_std]

pub mod mesh;
pub mod texture;
