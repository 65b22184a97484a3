//! A scene: where the camera stands, and what it sees.

use embedded_graphics_core::geometry::Size;
use topleft::stages::{Correction, Shader, Traversal};
use topleft::{
    Cull, Depth, DrawError, DrawList, Length, Mesh, Orthographic, Perspective, Pixel, Pose, Textured, Turn,
};

use crate::shade::{Look, Method, Shade, WithShader};

/// A camera, and objects from back to front.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// The name on a command line.
    pub name: &'static str,
    /// What it shows, in a line.
    pub about: &'static str,
    /// Where the camera stands.
    pub camera: Camera,
    /// Behind everything: red, green, blue.
    pub background: [u8; 3],
    /// What it sees.
    pub objects: &'static [Object],
}

/// Where the camera stands.
#[derive(Clone, Copy, Debug)]
pub enum Camera {
    /// On a circle round a target.
    Orbit {
        /// What it looks at.
        target: [Length; 3],
        /// Its distance from there.
        distance: Length,
        /// Above the horizon.
        pitch: Turn,
        /// Degrees from top to bottom.
        field_of_view: i32,
        /// The near and the far plane.
        depth: (f32, f32),
    },
    /// Straight on, without perspective: as many units from top to bottom.
    Front {
        /// Units from top to bottom.
        height: f32,
    },
}

/// Something to see.
#[derive(Clone, Copy, Debug)]
pub struct Object {
    /// Its shape.
    pub mesh: &'static Mesh<'static>,
    /// Where its origin is.
    pub at: [Length; 3],
    /// How large it is.
    pub scale: Length,
    /// How it turns in the course of an animation.
    pub spin: Spin,
    /// How it leans once it has turned: about the x, the y and the z axis, in this order.
    pub lean: [Turn; 3],
    /// What it is made of.
    pub look: Look,
    /// Which of its faces are left out.
    pub cull: Cull,
}

/// How an object turns, once in an animation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spin {
    /// Not at all.
    Still,
    /// About the y axis.
    Upright,
    /// About the y axis, twice as fast.
    Twice,
    /// About the y axis, leaning over.
    Tumbling,
}

/// What a viewer changes: how far the animation is, the camera's place, and the way of shading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// How far the objects have turned.
    pub turn: Turn,
    /// How far the camera has gone round.
    pub yaw: Turn,
    /// How much higher the camera stands.
    pub pitch: Turn,
    /// Times the distance.
    pub distance: Length,
    /// A way of shading for all objects, or each its own.
    pub shade: Option<Shade>,
    /// A way to find texels for all objects, or each its own.
    pub method: Option<Method>,
}

impl Default for View {
    fn default() -> Self {
        Self {
            turn: Turn::ZERO,
            yaw: Turn::ZERO,
            pitch: Turn::ZERO,
            distance: Length::ONE,
            shade: None,
            method: None,
        }
    }
}

impl Scene {
    /// Draws all objects into a list, for a target of `size` pixels.
    ///
    /// # Errors
    /// What did not fit, of all objects together, and the first of any other error.
    pub fn draw<P: Pixel, D: Depth, T: Traversal>(
        &self,
        list: &mut DrawList<'_, P, D, T>,
        size: Size,
        view: &View,
    ) -> Result<(), DrawError> {
        // Once a frame: they are made of floats.
        let cameras = (self.camera.orbiting(size, view), self.camera.front(size));
        let mut left_out = (0, 0);
        for object in self.objects {
            list.set_cull(object.cull);
            let pose = object.pose(view.turn);
            let shade = view.shade.unwrap_or(object.look.shade);
            let method = view.method.unwrap_or(object.look.method);
            let drawing = Drawing { list: &mut *list, cameras: &cameras, mesh: object.mesh, pose };
            match object.look.shader(shade, method, drawing) {
                Err(DrawError::Full { triangles, words }) => {
                    left_out = (left_out.0 + triangles, left_out.1 + words);
                }
                other => other?,
            }
        }
        match left_out {
            (0, 0) => Ok(()),
            (triangles, words) => Err(DrawError::Full { triangles, words }),
        }
    }

    /// The same with each object's texture as it is, its texels found by `correction`.
    ///
    /// # Errors
    /// As [`draw`](Self::draw), but the first only.
    pub fn draw_textured<P: Pixel, D: Depth, T: Traversal>(
        &self,
        list: &mut DrawList<'_, P, D, T>,
        size: Size,
        view: &View,
        correction: impl Correction,
    ) -> Result<(), DrawError> {
        self.draw_with(list, size, view, |object| Textured::new(&object.look.texture, correction))
    }

    /// The same with a shader for each object.
    ///
    /// # Errors
    /// As [`draw`](Self::draw), but the first only.
    pub fn draw_with<'a, P: Copy, D: Depth, T: Traversal, S: Shader<'a, P>>(
        &self,
        list: &mut DrawList<'a, P, D, T>,
        size: Size,
        view: &View,
        shader: impl Fn(&Object) -> S,
    ) -> Result<(), DrawError> {
        for object in self.objects {
            list.set_cull(object.cull);
            let (pose, shader) = (object.pose(view.turn), shader(object));
            if let Some(camera) = self.camera.orbiting(size, view) {
                list.draw(&camera, object.mesh, &pose, &shader)?;
            }
            if let Some(camera) = self.camera.front(size) {
                list.draw(&camera, object.mesh, &pose, &shader)?;
            }
        }
        Ok(())
    }

    /// Faces of all objects.
    pub fn faces(&self) -> usize {
        self.objects.iter().map(|object| object.mesh.faces().len()).sum()
    }

    /// Vertices of all objects.
    pub fn vertices(&self) -> usize {
        self.objects.iter().map(|object| object.mesh.positions().len()).sum()
    }
}

impl Object {
    /// Where the object stands once it has turned this far.
    pub fn pose(&self, turn: Turn) -> Pose {
        let pose = match self.spin {
            Spin::Still => Pose::new(),
            Spin::Upright => Pose::new().turned_y(turn),
            Spin::Twice => Pose::new().turned_y(turn + turn),
            Spin::Tumbling => Pose::new().turned_x(Turn::from_degrees(35)).turned_y(turn),
        };
        let [x, y, z] = self.lean;
        pose.turned_x(x).turned_y(y).turned_z(z).scaled(self.scale).at(self.at)
    }
}

impl Camera {
    /// The camera for a target of `size`, where it turns round the scene; nothing for one that stands in front.
    pub fn orbiting(&self, size: Size, view: &View) -> Option<Perspective> {
        let Self::Orbit { target, distance, pitch, field_of_view, depth } = *self else { return None };
        let away = [Length::ZERO, Length::ZERO, distance.saturating_mul(view.distance)];
        let eye =
            Pose::new().turned_x(Turn::ZERO - pitch - view.pitch).turned_y(view.yaw).at(target).apply(away);
        let [eye, target] = [eye, target].map(|point| point.map(Length::to_num::<f32>));
        Some(Perspective::new(size, Turn::from_degrees(field_of_view), depth.0..depth.1).look_at(eye, target))
    }

    /// The camera for a target of `size`, where it stands in front; nothing for one that turns.
    pub fn front(&self, size: Size) -> Option<Orthographic> {
        let Self::Front { height } = *self else { return None };
        Some(Orthographic::new(size, height, -1.0..1.0))
    }
}

/// An object on its way into a list.
struct Drawing<'l, 'a, 'c, P, D: Depth, T> {
    list: &'l mut DrawList<'a, P, D, T>,
    /// One of them.
    cameras: &'c (Option<Perspective>, Option<Orthographic>),
    mesh: &'static Mesh<'static>,
    pose: Pose,
}

impl<'a, P: Pixel, D: Depth, T: Traversal> WithShader<'a, P> for Drawing<'_, 'a, '_, P, D, T> {
    type Output = Result<(), DrawError>;

    fn with<S: Shader<'a, P>>(self, shader: &S) -> Self::Output {
        let Self { list, cameras: (orbiting, front), mesh, pose } = self;
        if let Some(camera) = orbiting {
            list.draw(camera, mesh, &pose, shader)?;
        }
        if let Some(camera) = front {
            list.draw(camera, mesh, &pose, shader)?;
        }
        Ok(())
    }
}
