//! The keys of configurations: one description makes a core's flat `Config`, the tables of its file, their ranges, and the
//! reference of keys in `docs/configuration.md`.

/// A key of a configuration file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// Its name, which no other table of the core has.
    pub name: &'static str,
    /// What it does.
    pub doc: &'static str,
    /// What it may be.
    pub values: Values,
    /// Who sets it, as a rule.
    pub set_by: SetBy,
}

/// What a key may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// Any number between the two, both included.
    Range(f64, f64),
    /// What the text says.
    Described(&'static str),
}

/// Who sets a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetBy {
    /// Whoever writes a configuration or a scene's overrides.
    User,
    /// The scene or the points, where no configuration is given.
    Input,
    /// Only a sweep over many values: no named configuration does.
    Sweep,
}

/// A table of a configuration file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table {
    /// Its name.
    pub name: &'static str,
    /// What its keys have in common.
    pub doc: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

/// What was a key, or looks like one, and follows from other keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Derived {
    /// The value's name.
    pub name: &'static str,
    /// How it follows.
    pub rule: &'static str,
    /// What it is.
    pub doc: &'static str,
}

/// A number outside its range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("`{key}` = {value}: expected {low} to {high}")]
pub struct OutOfRange {
    /// The key.
    pub key: &'static str,
    /// Its value.
    pub value: f64,
    /// Smallest value allowed.
    pub low: f64,
    /// Largest value allowed.
    pub high: f64,
}

impl OutOfRange {
    /// Checks one number.
    ///
    /// # Errors
    /// The number lies outside the range.
    pub fn check(key: &'static str, value: f64, low: f64, high: f64) -> Result<(), Self> {
        if (low..=high).contains(&value) { Ok(()) } else { Err(Self { key, value, low, high }) }
    }
}

/// A table: a struct of its keys, with defaults, ranges and the reference of its keys.
///
/// A key is `name: Type = default, range(low, high) | described("…"), SetBy;` behind its doc comment.
macro_rules! table {
    (
        $(#[doc = $about:literal])+
        $(#[derive($trait:ident)])?
        $vis:vis struct $name:ident {
            $(
                $(#[doc = $doc:literal])+
                $(#[serde($serde:meta)])?
                $key:ident: $type:ty = $default:expr,
                $(range($low:expr, $high:expr))? $(described($values:literal))?, $set_by:ident;
            )+
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
        $(#[derive($trait)])?
        #[serde(deny_unknown_fields, default)]
        $vis struct $name {
            $($(#[doc = $doc])+ $(#[serde($serde)])? pub $key: $type,)+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($key: $default,)+ }
            }
        }

        impl $name {
            /// The keys of the table.
            pub const KEYS: &'static [$crate::configuration::Key] = &[$($crate::configuration::Key {
                name: stringify!($key),
                doc: concat!($($doc),+),
                values: {
                    $($crate::configuration::Values::Range($low as f64, $high as f64))?
                    $($crate::configuration::Values::Described($values))?
                },
                set_by: $crate::configuration::SetBy::$set_by,
            },)+];
        }
    };
}

/// A core's configuration: the flat struct that models and hardware read, and the file of tables that it is read from.
macro_rules! configuration {
    (
        $(#[doc = $about:literal])+
        pub struct $config:ident, kind $kind:literal {
            $(
                $(#[doc = $table_doc:literal])+
                $table:ident: $Table:ident {
                    $(
                        $(#[doc = $doc:literal])+
                        $(#[serde($serde:meta)])?
                        $key:ident: $type:ty = $default:expr,
                        $(range($low:expr, $high:expr))? $(described($values:literal))?, $set_by:ident;
                    )+
                }
            )+
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(from = "File", into = "File")]
        pub struct $config {
            $($($(#[doc = $doc])+ pub $key: $type,)+)+
            /// Widths of the bus around the core.
            pub bus: $crate::bus::Config,
        }

        $($crate::configuration::table! {
            $(#[doc = $table_doc])+
            pub(crate) struct $Table {
                $(
                    $(#[doc = $doc])+
                    $(#[serde($serde)])?
                    $key: $type = $default, $(range($low, $high))? $(described($values))?, $set_by;
                )+
            }
        })+

        /// The core, as a file says it.
        #[derive(Clone, Copy, Default, serde::Serialize, serde::Deserialize)]
        pub(crate) enum Kind {
            #[default]
            #[serde(rename = $kind)]
            This,
        }

        /// A configuration as a file has it: in tables.
        #[derive(Default, serde::Serialize, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        pub(crate) struct File {
            pub(crate) kind: Kind,
            $(#[serde(default)] pub(crate) $table: $Table,)+
            #[serde(default)]
            pub(crate) bus: $crate::bus::Config,
        }

        impl From<File> for $config {
            fn from(File { kind: Kind::This, $($table: $Table { $($key),+ },)+ bus }: File) -> Self {
                Self { $($($key,)+)+ bus }
            }
        }

        impl From<$config> for File {
            fn from($config { $($($key,)+)+ bus }: $config) -> Self {
                Self { kind: Kind::This, $($table: $Table { $($key),+ },)+ bus }
            }
        }

        impl Default for $config {
            fn default() -> Self {
                File::default().into()
            }
        }

        impl $config {
            /// The tables of a configuration file, besides the line `kind`.
            pub const TABLES: &'static [$crate::configuration::Table] = &[
                $($crate::configuration::Table {
                    name: stringify!($table),
                    doc: concat!($($table_doc),+),
                    keys: $Table::KEYS,
                },)+
                $crate::configuration::Table {
                    name: "bus",
                    doc: $crate::bus::config::ABOUT,
                    keys: $crate::bus::Config::KEYS,
                },
            ];

            /// Checks every number that has a range.
            fn check_ranges(&self) -> Result<(), $crate::configuration::OutOfRange> {
                $($($(
                    let (low, high) = ($low as f64, $high as f64);
                    $crate::configuration::OutOfRange::check(stringify!($key), f64::from(self.$key), low, high)?;
                )?)+)+
                Ok(())
            }
        }
    };
}

pub(crate) use {configuration, table};
