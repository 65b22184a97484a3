//! The scenes.
#![no_std]
