use super::*;
use crate::places;
use crate::splat::records::{Uniforms, uniform_formats};

#[test]
fn default_is_valid() {
    assert_eq!(Config::default().validate(), Ok(()));
}

#[test]
fn errors_name_key_and_range() {
    let error = Config { width: 0, ..Config::default() }.validate().unwrap_err();
    assert_eq!(error.to_string(), "`width` = 0: expected 1 to 4096");
    let error = Config { kernel_index_bits: 3, ..Config::default() }.validate().unwrap_err();
    assert_eq!(error.to_string(), "`kernel_index_bits` = 3: expected 4 to 10");
    let error = Config { kernel_fraction_bits: 11, ..Config::default() }.validate().unwrap_err();
    assert_eq!(error.to_string(), "`kernel_fraction_bits` = 11: expected 0 to 10");
    for (memory_ports, rasterizers) in [(0, 1), (2, 1), (3, 4), (8, 8)] {
        let error = Config { memory_ports, rasterizers, ..Config::default() }.validate().unwrap_err().to_string();
        let expected =
            format!("`memory_ports` = {memory_ports} with `rasterizers` = {rasterizers}: expected 1, 2 or 4");
        assert!(error.starts_with(&expected), "{error}");
    }
    let error = Config { continuous: 15, ..Config::default() }.validate().unwrap_err();
    assert_eq!(error.to_string(), "`continuous` + `cardinal` = 15: expected 1 to 14 attributes");
    let geometry = Format::F24;
    let error = Config { geometry, rasterizer: Some(Format::F32.into()), ..Config::default() }.validate().unwrap_err();
    assert!(error.to_string().starts_with("`rasterizer` = \"f32\": expected one of \"geometry\""), "{error}");
    for (text, named) in [
        ("[image]\nwidht = 3", ["widht", "width"]),
        ("[features]\ndivision = \"exact\"", ["exact", "`newton`"]),
        ("[features]\nrasterizer = \"f8\"", ["f24", "or \"geometry\""]),
        ("[features]\nrasterizer = \"fixed20\"", ["`fixed20`", "fixed18"]),
    ] {
        let error = toml::from_str::<Config>(&format!("kind = \"splat\"\n{text}")).unwrap_err().to_string();
        assert!(named.iter().all(|name| error.contains(name)), "{error}");
    }
    let error =
        toml::from_str::<Config>("kind = \"splat\"\n[features]\nattribute = \"fixed9\"").unwrap_err().to_string();
    assert!(error.contains("`fixed9`") && error.contains("fixed12"), "{error}");
}

#[test]
fn flipquad_has_two_samples_a_pixel() {
    let config = |width| Config { width, sampling: Sampling::Flipquad, ..Config::default() };
    assert_eq!(config(66).validate(), Ok(()));
    assert!(config(65).validate().unwrap_err().to_string().contains("expected a multiple of 2"));
}

#[test]
fn the_rasterizer_computes_in_its_own_format_or_that_of_geometry() {
    let formats = [None, Some(Format::F24.flushed().into()), Some(RasterFormat::Fixed(Coefficient::Eighteen))];
    let scales = [Format::F32, Format::F24.flushed()].map(UniformFormat::Float);
    let scales = scales.into_iter().chain([UniformFormat::Fixed(Coefficient::FILTER_SCALE)]);
    for ((rasterizer, name), scale) in formats.into_iter().zip(["geometry", "f24-ftz", "fixed18"]).zip(scales) {
        let config = Config { rasterizer, geometry: Format::F32, ..Config::default() };
        assert_eq!(config.validate(), Ok(()));
        let text = toml::to_string(&config).unwrap();
        assert!(text.contains(&format!("rasterizer = \"{name}\"")), "{text}");
        assert_eq!(toml::from_str(&text), Ok(config.clone()));
        let formats: Vec<_> = uniform_formats(&config).collect();
        assert_eq!(formats[places::<Uniforms>(&config).filter_scale.unwrap()], scale);
        assert_eq!(formats[places::<Uniforms>(&config).filter_radius.unwrap()], UniformFormat::Float(Format::F32));
    }
}

#[test]
fn a_rasterizer_in_fixed_point_has_no_depths_of_samples() {
    for (_, coefficient) in Coefficient::NAMED {
        let rasterizer = Some(RasterFormat::Fixed(coefficient));
        let config = Config { rasterizer, geometry: Format::F24, ..Config::default() };
        assert_eq!(config.validate(), Ok(()));
        let error = Config { depth: FragmentDepth::Plane, ..config }.validate().unwrap_err().to_string();
        assert!(error.contains("`depth` = \"center\"") && error.contains("fixed"), "{error}");
    }
}

#[test]
fn index_widths() {
    let widths = [1, 2, 3, 4, 5, 8, 9].map(index_bits);
    assert_eq!(widths, [1, 1, 2, 2, 3, 3, 4]);
    assert_eq!(Config { width: 512, height: 512, ..Config::default() }.tile_bits(), 12);
}

#[test]
fn the_bins_of_a_place_have_tiles_side_by_side() {
    let moving = |time_bins| Config { time_bins, screen_filter: Feature::Off, ..Config::default() };
    let message = |config: Config| config.validate().map_err(|error| error.to_string()).unwrap_err();
    assert!([0, 1, 2, 4, 8].iter().all(|&bins| moving(bins).validate().is_ok()));
    assert!(message(moving(3)).contains("power of two up to 8"));
    let config = Config { width: 66, ..moving(4) };
    assert_eq!((config.tile_columns(), config.column_bits(), config.tile_column_bits()), (36, 7, 6));
    assert_eq!((config.last_place()[0], config.bin_time_bits()), (35, 15));
    assert!(message(Config { screen_filter: Feature::On, ..moving(1) }).contains("`screen_filter` = \"off\""));
    assert!(message(Config { culling: Feature::Off, ..moving(1) }).contains("`culling` = \"on\""));
    let narrow = Some(Format::BF16.flushed().into());
    assert!(message(Config { rasterizer: narrow, ..moving(2) }).contains("`rasterizer` = \"geometry\""));
}
