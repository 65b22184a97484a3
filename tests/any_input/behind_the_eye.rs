//! Triangles with vertices behind the eye, beyond the far plane and beside the view, one at a time.

use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use proptest::prelude::*;
use reference::clip::{ClipVertex, clip};
use reference::matrix::Matrix;
use reference::raster::{covers, pixel_box};
use reference::setup::{Triangle, fan, snap};
use reference::transform::{Viewport, model_position};
use topleft::{
    Camera, Cull, DrawList, Flat, Length, ListTriangle, Mesh, NoDepth, Perspective, Pose, Strip, Turn,
};

use crate::edges::to_edges;
use crate::support::check;
use crate::support::tolerance::{self, vertex_on_screen};

/// Turned red by: a triangle that is left out because the near plane cuts it, no near plane, 12 bits of t, distances to
/// the guard rectangle in 32 bits, a fan without its last triangle.
#[test]
fn what_is_visible_of_a_triangle_behind_the_eye_is_drawn() {
    const VIEW: Viewport = Viewport { width: 64, height: 48 };
    let camera = Perspective::new(Size::new(64, 48), Turn::from_degrees(80), 0.1..20.0);
    let unit = 2.0_f64.powi(-camera.matrix().exponent());
    let exact = Matrix([0, 1, 2, 3].map(|row| camera.matrix().row(row).map(|m| f64::from(m) * unit)));
    let largest = exact.0.iter().flatten().fold(0.0_f64, |most, e| most.max(e.abs()));
    let mut counts = [0_u64; 3];
    let counted = core::cell::RefCell::new(&mut counts);
    let positions = prop::array::uniform3(prop::array::uniform3(any::<i16>()));
    check(3000, &(positions, prop::sample::select(vec![1, 4, 30])), |(positions, half)| {
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
        let mesh = mesh.with_box([Length::ZERO; 3], Length::from_num(half));
        let corners = [0, 1, 2].map(|vertex| ClipVertex {
            position: exact.apply_point(model_position(&mesh, vertex)),
            varyings: [],
        });
        let polygon = clip(corners, &[]);
        let places: Vec<[f64; 2]> = polygon.iter().map(|v| VIEW.to_screen(v.position)).collect();
        let snapped: Vec<_> = places.iter().map(|p| p.map(|c| snap(c).expect("finite"))).collect();
        // Four columns of at most the largest element; the pose is the mesh's half edge.
        let half = f64::from(half);
        let error = tolerance::clip(largest * half, 4.0 * largest * half);
        let moved = polygon.iter().zip(&places).map(|(vertex, [x, y])| {
            1.0 + vertex_on_screen(error, vertex.position[3], 32.0, (x - 32.0).hypot(y - 24.0))
        });
        let band = moved.fold(0.0, f64::max) * 2.0_f64.sqrt();
        let mut storage = ([0; 64], [ListTriangle::EMPTY; 8]);
        let mut list = DrawList::<u16, NoDepth>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::WHITE)).map_err(|e| format!("{e:?}"))?;
        let mut cells = [0; 64 * 48];
        list.render(0..48, &mut Strip::new(64, &mut cells).unwrap());
        let triangles: Vec<Triangle> = fan(&snapped).into_iter().map(|t| t.map(|i| snapped[i])).collect();
        let mut covered = [false; 64 * 48];
        for &triangle in &triangles {
            let (columns, rows) = pixel_box(triangle, VIEW);
            for y in rows {
                for x in columns.clone() {
                    covered[(y * 64 + x) as usize] |= covers(triangle, x, y);
                }
            }
        }
        let mut counts = counted.borrow_mut();
        counts[0] += u64::from(corners.iter().any(|v| v.position[3] < 0.0) && covered.contains(&true));
        for (index, (&cell, &covered)) in cells.iter().zip(&covered).enumerate() {
            counts[1] += u64::from(covered);
            if covered == (cell != 0) {
                continue;
            }
            counts[2] += 1;
            let (x, y) = ((index % 64) as i64, (index / 64) as i64);
            let far = triangles.iter().map(|&t| to_edges(t, x, y)).fold(f64::INFINITY, f64::min);
            if far > band {
                return Err(format!("{x}, {y}: {cell} although covered is {covered}, {far} of {band} steps"));
            }
        }
        Ok(())
    });
    let [behind, pixels, differing] = counts;
    println!("{behind} triangles from behind the eye; {differing} of {pixels} px on an edge differ");
    assert!(behind > 300 && pixels > 100_000);
}
