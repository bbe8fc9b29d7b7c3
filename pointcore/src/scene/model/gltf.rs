//! glTF and GLB: the vertices of all meshes where the scene's nodes put them, their faces, normals, and colors. Textures are not looked at.

use super::{Model, fan, strip};
use ::gltf::buffer::{self, Source};
use ::gltf::mesh::{Mode, Reader};
use ::gltf::{Document, Gltf, Node, Primitive};
use glam::{DMat3, DMat4, DVec3};
use std::path::Path;

/// Nodes within nodes that are followed.
const DEPTH_LIMIT: usize = 256;

/// Parses a whole file, with the buffers that it names beside it; an error says what is wrong with it.
pub(super) fn parse(bytes: &[u8], path: &Path) -> Result<Model, String> {
    let problem = |error: ::gltf::Error| format!("not a glTF file that can be read: {error}");
    let Gltf { document, blob } = Gltf::from_slice(bytes).map_err(problem)?;
    let buffers = ::gltf::import_buffers(&document, path.parent(), blob);
    let buffers = buffers.map_err(|error| missing_buffer(&document, path).unwrap_or_else(|| problem(error)))?;
    check_accessors(&document, &buffers)?;
    let mut gathered = Gathered { buffers, model: Model::default(), normals: Vec::new(), colors: Vec::new() };
    let roots: Vec<Node> = match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => scene.nodes().collect(),
        None => document.nodes().collect(),
    };
    for node in roots {
        gathered.node(&node, DMat4::IDENTITY, 0)?;
    }
    let Gathered { mut model, normals, colors, .. } = gathered;
    let all = |given: &[bool]| !given.is_empty() && given.iter().all(|given| *given);
    // Faces give all vertices a normal where some primitives have none of their own.
    let has_normals = all(&normals.iter().map(Option::is_some).collect::<Vec<_>>());
    model.normals = has_normals.then(|| normals.into_iter().flatten().collect());
    model.colors =
        colors.iter().any(Option::is_some).then(|| colors.into_iter().map(|color| color.unwrap_or(WHITE)).collect());
    Ok(model)
}

/// The file beside the model that is not there; the reader does not say which.
fn missing_buffer(document: &Document, path: &Path) -> Option<String> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let is_missing = |uri: &str| !uri.contains(':') && !folder.join(uri).is_file();
    document.buffers().find_map(|buffer| match buffer.source() {
        Source::Uri(uri) if is_missing(uri) => {
            let index = buffer.index();
            Some(format!(
                "not a glTF file that can be read: its buffer {index} is the file `{uri}`, which is not beside it"
            ))
        }
        Source::Uri(_) | Source::Bin => None,
    })
}

/// A list of numbers may promise any number of them; the reader takes those that are there.
fn check_accessors(document: &Document, buffers: &[buffer::Data]) -> Result<(), String> {
    for accessor in document.accessors() {
        let Some(view) = accessor.view() else { continue };
        let (first, last) = (accessor.offset(), accessor.count().saturating_sub(1));
        let needed = last.saturating_mul(view.stride().unwrap_or(accessor.size())).saturating_add(accessor.size());
        let given = buffers.get(view.buffer().index()).map_or(0, |data| data.0.len()).saturating_sub(view.offset());
        let given = given.min(view.length());
        if needed.saturating_add(first) > given {
            let (index, count) = (accessor.index(), accessor.count());
            let given = given.saturating_sub(first);
            return Err(format!(
                "not a glTF file that can be read: accessor {index} promises {count} values, which need {needed} bytes, in {given}"
            ));
        }
    }
    Ok(())
}

/// What a vertex without a color has: that of a material which says nothing else.
const WHITE: [f32; 3] = [1.0; 3];

/// What has been read so far.
struct Gathered {
    buffers: Vec<buffer::Data>,
    model: Model,
    normals: Vec<Option<DVec3>>,
    colors: Vec<Option<[f32; 3]>>,
}

impl Gathered {
    fn node(&mut self, node: &Node, parent: DMat4, depth: usize) -> Result<(), String> {
        if depth > DEPTH_LIMIT {
            return Err(format!("node {} lies {depth} nodes deep: expected {DEPTH_LIMIT} at most", node.index()));
        }
        let columns = node.transform().matrix().map(|column| column.map(f64::from));
        let world = parent * DMat4::from_cols_array_2d(&columns);
        for primitive in node.mesh().into_iter().flat_map(|mesh| mesh.primitives()) {
            self.primitive(&primitive, world);
        }
        node.children().try_for_each(|child| self.node(&child, world, depth + 1))
    }

    fn primitive(&mut self, primitive: &Primitive, world: DMat4) {
        let buffers = &self.buffers;
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(|data| &data.0[..]));
        let Some(positions) = reader.read_positions() else { return };
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let first = self.model.points.len();
        self.model.points.extend(positions.map(|position| world.transform_point3(vector(position))));
        let count = self.model.points.len() - first;

        // Normals are across the surface, wherever its tangents go.
        let across = DMat3::from_mat4(world).inverse().transpose();
        self.normals.extend(reader.read_normals().into_iter().flatten().take(count).map(|n| Some(across * vector(n))));
        self.normals.resize(first + count, None);
        let [red, green, blue, _] = primitive.material().pbr_metallic_roughness().base_color_factor();
        let factor = [red, green, blue];
        let tinted = |color: [f32; 3]| [0, 1, 2].map(|i| (color[i] * factor[i]).clamp(0.0, 1.0));
        let given = reader.read_colors(0).map(|colors| colors.into_rgb_f32());
        self.colors.extend(given.into_iter().flatten().take(count).map(|color| Some(tinted(color))));
        self.colors.resize(first + count, (factor != WHITE).then_some(tinted(WHITE)));
        self.model.triangles.extend(triangles(primitive.mode(), &indices(&reader, first, count)));
    }
}

/// A primitive's indices, counted from the model's first vertex.
fn indices<'a, 's, F>(reader: &Reader<'a, 's, F>, first: usize, count: usize) -> Vec<u32>
where
    F: Clone + Fn(::gltf::Buffer<'a>) -> Option<&'s [u8]>,
{
    let index = |index: u32| index.saturating_add(first as u32);
    match reader.read_indices() {
        Some(indices) => indices.into_u32().map(index).collect(),
        None => (0..count as u32).map(index).collect(),
    }
}

fn triangles(mode: Mode, indices: &[u32]) -> Vec<[u32; 3]> {
    match mode {
        Mode::Triangles => indices.as_chunks().0.to_vec(),
        Mode::TriangleStrip => strip(indices).collect(),
        Mode::TriangleFan => fan(indices).collect(),
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle in the xy plane whose node moves it by (0, 0, 5) and doubles it; its buffer lies in the file itself.
    const TRIANGLE: &str = include_str!("../../../../fuzz/seeds/gltf/triangle.gltf");

    fn read(text: &str) -> Result<Model, String> {
        parse(text.as_bytes(), Path::new("triangle.gltf"))
    }

    #[test]
    fn vertices_lie_where_nodes_put_them() {
        let model = read(TRIANGLE).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(model.points, [DVec3::new(0.0, 0.0, 5.0), DVec3::new(2.0, 0.0, 5.0), DVec3::new(0.0, 2.0, 5.0)]);
        assert_eq!((model.triangles, model.normals), (vec![[0, 1, 2]], None));
        assert_eq!(model.colors, Some(vec![[0.0, 1.0, 0.0]; 3]), "the material's");
    }

    #[test]
    fn what_cannot_be_read_is_said() {
        for (from, to) in
            [("\"byteLength\": 36, \"uri\"", "\"byteLength\": 3600, \"uri\""), ("data:application", "gone"), ("{", "")]
        {
            assert!(TRIANGLE.contains(from), "the test replaces nothing");
            assert!(read(&TRIANGLE.replacen(from, to, 1)).is_err_and(|problem| problem.contains("glTF")), "{to}");
        }
    }
}
