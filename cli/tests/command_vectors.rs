//! `pointcore vectors` as a driver's author meets it.

use serde_json::Value;
use std::fs;

use super::command::{WRONG_INPUT, Workplace, json};

/// A scene whose hardware is small, on a narrow bus.
const SCENE: &str = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = 1, far = 10 }\n\
                     image = { width = 20, height = 12 }\noverrides = { stream_bits = 32 }\n\
                     [[object]]\nkind = \"sphere\"\npoints = 40\nouter_radius = 1\n";
/// Hardware for a search in 40 points.
const CONFIG: &str = "kind = \"search\"\n[implementation]\nthreads = 4\nlanes = 2\n[features]\nneighbors = 4\ntree_depth = 3\nbucket = 8\nindex_bits = 8\n";

/// The vectors in a folder: the document, and how to read packets.
struct Written {
    folder: std::path::PathBuf,
    document: Value,
}

impl Written {
    fn new(workplace: &Workplace, folder: &str) -> Self {
        let folder = workplace.path().join(folder);
        let text = fs::read_to_string(folder.join("vectors.json")).expect("vectors are written");
        Self { folder, document: json(&text) }
    }

    fn register(&self, name: &str) -> Option<(u64, u64)> {
        let registers = self.document["registers"].as_array().expect("registers are a list");
        let register = registers.iter().find(|register| register["name"] == name)?;
        Some((register["address"].as_u64()?, register["value"].as_u64()?))
    }

    fn region(&self, name: &str) -> &Value {
        let regions = self.document["memory"].as_array().expect("memory is a list");
        regions.iter().find(|region| region["name"] == name).expect("the region is there")
    }

    fn file(&self, name: &Value) -> Vec<u8> {
        fs::read(self.folder.join(name.as_str().expect("a file's name is a text"))).expect("the file is written")
    }

    /// The fields of every packet, by name.
    fn packets(&self, side: &str) -> Vec<impl Fn(&str) -> u64> {
        let side = &self.document[side];
        let bytes = self.file(&side["file"]);
        let size = side["packet_bytes"].as_u64().unwrap() as usize;
        assert_eq!(bytes.len(), size * side["packets"].as_u64().unwrap() as usize);
        let packet = |packet: &[u8]| {
            let (packet, fields) = (packet.to_vec(), side["fields"].as_array().unwrap().clone());
            move |name: &str| {
                let field = fields.iter().find(|field| field["name"] == name).expect("the field is there");
                let [byte, bytes] = ["byte", "bytes"].map(|key| field[key].as_u64().unwrap() as usize);
                packet[byte..byte + bytes].iter().rev().fold(0, |value, byte| value << 8 | u64::from(*byte))
            }
        };
        bytes.chunks_exact(size).map(packet).collect()
    }
}

#[test]
fn wrong_input_is_refused() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    workplace.write("config.toml", CONFIG);
    workplace.write("narrow.toml", &CONFIG.replace("index_bits = 8", "index_bits = 6"));
    workplace.write("odd.toml", &format!("{CONFIG}[bus]\nmemory_bits = 48\n"));
    let search = ["--points", "surface:40", "--k", "3", "--config"];
    for (arguments, parts) in [
        (&["scene.toml", "--base", "0x10000800"][..], ["0x10000800", "multiple of 0x1000"]),
        (&["scene.toml", "--base", "0x100000000"], ["0x100000000", "32 bits"]),
        (&["scene.toml", "--base", "0xfffff000"], ["reconstruction buffer", "lower base"]),
        (&["scene.toml", "--set", "overrides.stream_bits=48"], ["`stream_bits`", "32, 64"]),
        (&["--points", "surface:40", "--k", "0"], ["'0' for '--k", "1 to 64"]),
        (&["--points", "surface:40", "--epsilon", "0.1"], ["--epsilon", "timing"]),
        (&[&search[..], &["narrow.toml", "--order", "grid:2x2"]].concat(), ["160 queries", "number only 64"]),
        (&[&search[..], &["odd.toml"]].concat(), ["odd.toml", "`memory_bits` = 48"]),
    ] {
        workplace.fails(WRONG_INPUT, &[&["vectors", "-o", "out"], arguments].concat(), &parts);
    }
    for arguments in [
        &[][..],
        &["scene.toml", "--points", "surface:40"],
        &["scene.toml", "--k", "3"],
        &["--points", "surface:40", "--set", "image.width=3"],
        &["scene.toml", "--base", "here"],
    ] {
        let output = workplace.pointcore(&[&["vectors", "-o", "out"], arguments].concat());
        assert_eq!(output.status.code(), Some(WRONG_INPUT), "{arguments:?}");
    }
    assert!(!workplace.path().join("out").exists(), "nothing is written on wrong input");
}

#[test]
fn a_frame_is_what_the_model_renders() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    workplace.succeeds(&["vectors", "scene.toml", "--base", "0x2000", "-o", "frame"]);
    let frame = Written::new(&workplace, "frame");
    assert_eq!(frame.document["top"], "splat_axi");
    assert_eq!(frame.register("buffer_base"), Some((0x080, 0x2000)));
    assert_eq!(frame.register("m00").map(|(address, _)| address), Some(0x100));
    assert_eq!(frame.register("filter_scale").map(|(address, _)| address), Some(0x158));
    let buffer = frame.region("pixel");
    // 20 × 12 pixels are in 3 × 2 tiles, whose numbers have 2 + 1 bits, on two surfaces.
    assert_eq!(buffer["bytes"].as_u64(), Some(2 * 8 * 64 * buffer["stride"].as_u64().unwrap()));

    let splats = frame.packets("send");
    assert_eq!(splats.iter().map(|splat| splat("end")).collect::<Vec<_>>(), [vec![0; 40], vec![1]].concat());
    let fragments = frame.packets("receive");
    let ends = fragments.iter().map(|fragment| fragment("end"));
    assert_eq!(ends.collect::<Vec<_>>(), [vec![0; fragments.len() - 1], vec![1]].concat());
    let report = json(&workplace.succeeds(&["run", "scene.toml", "--model", "golden", "--json"]));
    assert_eq!(report["fragments"].as_u64(), Some(fragments.len() as u64 - 1));
    workplace.succeeds(&["gen", "frame/config.toml", "-o", "verilog"]);
}

#[test]
fn a_search_finds_what_the_model_finds() {
    let workplace = Workplace::new();
    workplace.write("window.toml", CONFIG);
    let cached = CONFIG
        .replace("[implementation]\n", "[implementation]\ntree_cache = 16\n")
        .replace("[features]\n", "[features]\nneighbor_cache = 2\n");
    workplace.write("caches.toml", &format!("{cached}[bus]\nmemory_bits = 512\n"));
    let search = ["--points", "surface:40", "--order", "file", "--k", "3", "--config"];
    let neighbors = |config| {
        let arguments = [&["knn"][..], &search, &[config, "--model", "golden", "--json", "-o", "knn"]].concat();
        workplace.succeeds(&arguments);
        json(&fs::read_to_string(workplace.path().join("knn/neighbors.json")).expect("neighbors are written"))
    };
    for (config, tree_port, tree_bytes) in [("window.toml", "s_axi", 16 * 8), ("caches.toml", "m_axi_tree", 16 * 64)] {
        workplace.succeeds(&[&["vectors"], &search[..], &[config, "-o", "search"]].concat());
        let vectors = Written::new(&workplace, "search");
        assert_eq!(vectors.document["top"], "search_axi");
        assert_eq!(vectors.register("queries"), Some((0x088, 40)));
        let [points, tree] = ["points", "tree"].map(|name| vectors.region(name));
        assert_eq!(vectors.register("points_base").map(|(_, base)| base), points["base"].as_u64());
        assert_eq!((tree["port"].as_str(), tree["bytes"].as_u64()), (Some(tree_port), Some(tree_bytes)));
        let in_memory = tree_port == "m_axi_tree";
        assert_eq!(vectors.register("tree_base").map(|(_, base)| base), tree["base"].as_u64().filter(|_| in_memory));
        assert_eq!(vectors.register("cache_far_scale").is_some(), in_memory);
        for region in [points, tree] {
            assert_eq!(vectors.file(&region["file"]).len() as u64, region["bytes"].as_u64().unwrap());
        }
        let queries = vectors.packets("send");
        assert!(queries.iter().enumerate().all(|(number, query)| query("number") == number as u64));

        // A result's distance, as the search reports it, and the end of every query.
        let expected = neighbors(config);
        let expected = expected.as_array().unwrap().iter().map(|neighbors| neighbors.as_array().unwrap());
        let distances = expected.enumerate().flat_map(|(number, neighbors)| {
            let last = neighbors.len() - 1;
            neighbors.iter().enumerate().map(move |(rank, neighbor)| {
                let distance2 = neighbor["distance2"].as_f64().unwrap() as f32;
                (number as u64, u64::from(rank == last), 1, u64::from(distance2.to_bits()))
            })
        });
        let results = vectors.packets("receive");
        let results =
            results.iter().map(|result| (result("number"), result("last"), result("found"), result("distance2")));
        assert_eq!(results.collect::<Vec<_>>(), distances.collect::<Vec<_>>(), "{config}");
    }
    let far = [&["vectors"], &search[..], &["window.toml", "--radius", "1e-6", "--queries", "far.obj", "-o", "none"]];
    workplace.write("far.obj", "v 1000 0 0\n");
    workplace
        .succeeds(&far.concat().into_iter().filter(|word| !["--order", "file"].contains(word)).collect::<Vec<_>>());
    let vectors = Written::new(&workplace, "none");
    let results = vectors.packets("receive");
    let [result] = &results[..] else { panic!("one result closes a query without neighbors") };
    assert_eq!(["number", "last", "found"].map(result), [0, 1, 0]);
}
