//! The scenes that tests, examples and tools of topleft draw: one list for all of them.
//!
//! A scene is data: a view, and objects with a mesh, a pose and a look. [`Scene::draw`] draws it into any list.
#![no_std]

pub mod mesh;
pub mod texture;

mod all;
mod demo;
mod scene;
mod shade;

pub use all::{SCENES, by_name};
pub use scene::{Camera, Object, Scene, Spin, View};
pub use shade::{Look, Method, Shade, sun};
