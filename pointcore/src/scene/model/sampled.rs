//! Another number of points for a model: spread evenly over its faces, or some of a point set's.

use super::Model;
use crate::scene::shapes::lattice;
use glam::DVec2;

impl Model {
    /// The model as `count` points of its faces, evenly spread, with normals and colors between those of the vertices; without faces, every
    /// so-many-th of its points, and all where there are no more. Faces without any area leave the model as it is.
    #[must_use]
    pub fn sampled(self, count: usize) -> Self {
        if self.triangles.is_empty() { self.thinned(count) } else { self.spread(count) }
    }

    fn thinned(self, count: usize) -> Self {
        let total = self.points.len();
        if total <= count {
            return self;
        }
        let indices: Vec<usize> =
            (0..count).map(|index| (index as u128 * total as u128 / count as u128) as usize).collect();
        let points = indices.iter().map(|&index| self.points[index]).collect();
        let normals = self.normals.map(|normals| indices.iter().map(|&index| normals[index]).collect());
        let colors = self.colors.map(|colors| indices.iter().map(|&index| colors[index]).collect());
        let thin = |values: &Vec<f64>| indices.iter().map(|&index| values[index]).collect();
        let attributes = self.attributes.iter().map(|(name, values)| (name.clone(), thin(values))).collect();
        Self { points, normals, colors, attributes, ..self }
    }

    fn spread(self, count: usize) -> Self {
        let corners = |triangle: &[u32; 3]| triangle.map(|index| self.points[index as usize]);
        let area = |triangle: &[u32; 3]| {
            let [a, b, c] = corners(triangle);
            (b - a).cross(c - a).length()
        };
        let mut sum = 0.0;
        let mut upto = Vec::with_capacity(self.triangles.len());
        for triangle in &self.triangles {
            sum += area(triangle);
            upto.push(sum);
        }
        if !(sum > 0.0 && sum.is_finite()) {
            return self;
        }
        let mut sampled = Self {
            normals: self.normals.is_some().then(Vec::new),
            colors: self.colors.is_some().then(Vec::new),
            sensor: self.sensor,
            dropped: self.dropped.clone(),
            ..Self::default()
        };
        let mut flat = Vec::with_capacity(count);
        for index in 0..count {
            let DVec2 { x, y } = lattice(index, count);
            let place = upto.partition_point(|upto| *upto <= x * sum).min(upto.len() - 1);
            let triangle = self.triangles[place];
            let before = if place == 0 { 0.0 } else { upto[place - 1] };
            // The triangle's part of the lattice, whose first coordinate goes through all triangles, is a lattice of its own.
            let along = ((x * sum - before) / (upto[place] - before)).clamp(0.0, 1.0);
            let root = along.sqrt();
            let weights = [1.0 - root, root * (1.0 - y), root * y];
            let [a, b, c] = corners(&triangle);
            sampled.points.push(weights[0] * a + weights[1] * b + weights[2] * c);
            flat.push((b - a).cross(c - a));
            if let (Some(sums), Some(normals)) = (&mut sampled.normals, &self.normals) {
                let [a, b, c] = triangle.map(|index| normals[index as usize].normalize_or_zero());
                sums.push(weights[0] * a + weights[1] * b + weights[2] * c);
            }
            if let (Some(mixed), Some(colors)) = (&mut sampled.colors, &self.colors) {
                let [a, b, c] = triangle.map(|index| colors[index as usize]);
                let weights = weights.map(|weight| weight as f32);
                mixed.push([0, 1, 2].map(|i| weights[0] * a[i] + weights[1] * b[i] + weights[2] * c[i]));
            }
        }
        // Without normals of their own, points of a face have the face's: a cube keeps its edges.
        sampled.normals.get_or_insert(flat);
        sampled
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::neighbors;
    use glam::DVec3;

    #[test]
    fn faces_are_covered_evenly_and_keep_their_edges() {
        let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .map(DVec3::from_array);
        let colors = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0; 3]];
        let triangles = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4]];
        let model = Model { points: points.to_vec(), colors: Some(colors.to_vec()), triangles, ..Model::default() };
        let sampled = model.sampled(5000);
        let normals = sampled.normals.as_ref().expect("faces give them");
        let on_floor = sampled.points.iter().filter(|point| point.z == 0.0 && point.x > 0.0).count();
        assert!((3990..=4010).contains(&on_floor), "four fifths of the area: {on_floor}");
        for (index, point) in sampled.points.iter().enumerate() {
            let expected = if point.x > 0.0 { DVec3::Z } else { DVec3::X };
            assert!(normals[index].normalize().dot(expected) > 0.999, "{point}: {}", normals[index]);
        }
        let red_at_left = sampled.points.iter().zip(sampled.colors.expect("vertices have them"));
        assert!(
            red_at_left
                .filter(|(point, _)| point.z == 0.0)
                .all(|(point, color)| (f64::from(color[2]) - point.x / 2.0).abs() < 1e-6)
        );
        let spacing = neighbors::spacing(&sampled.points).expect("no two are the same");
        let mean = spacing.iter().sum::<f64>() / spacing.len() as f64;
        let greatest = spacing.iter().copied().fold(0.0, f64::max);
        assert!(greatest < 2.5 * mean, "{greatest}, mean {mean}: no hole");
    }

    #[test]
    fn points_without_faces_are_thinned() {
        let points: Vec<_> = (0..10).map(|x| DVec3::new(x.into(), 0.0, 0.0)).collect();
        let model = Model { points, colors: Some(vec![[1.0; 3]; 10]), ..Model::default() };
        let thinned = model.clone().sampled(5);
        assert_eq!(thinned.points.iter().map(|point| point.x).collect::<Vec<_>>(), [0.0, 2.0, 4.0, 6.0, 8.0]);
        assert_eq!(thinned.colors.map(|colors| colors.len()), Some(5));
        assert_eq!(model.clone().sampled(11), model);
        let flat = Model { triangles: vec![[0, 1, 2]], ..model };
        assert_eq!(flat.clone().sampled(5), flat, "faces without area");
    }
}
