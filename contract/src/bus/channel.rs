//! The channels of a bus: streams whose ports are called as AMBA calls them, `<bus>_<channel>valid`.

use std::marker::PhantomData;

use crate::unit::{Group, Kind, channel_port};
use crate::{Record, fields};

/// What the port is called that says whether something is there.
pub const VALID: &str = "valid";

macro_rules! channels {
    ($($(#[doc = $about:literal])* $channel:ident, $kind:expr;)*) => {
        $(
            $(#[doc = $about])*
            #[derive(Debug)]
            pub struct $channel<R> {
                /// What the ports of its bus begin with.
                pub bus: &'static str,
                /// What its own ports begin with behind that.
                pub channel: &'static str,
                /// What it is for.
                pub doc: &'static str,
                record: PhantomData<R>,
            }

            impl<R> $channel<R> {
                /// A channel of these names.
                #[must_use]
                pub const fn new(bus: &'static str, channel: &'static str, doc: &'static str) -> Self {
                    Self { bus, channel, doc: doc.trim_ascii(), record: PhantomData }
                }

                /// The name of one of its ports: of [`VALID`], of [`READY`](crate::unit::READY), of a field.
                #[must_use]
                pub fn port(&self, part: &str) -> String {
                    channel_port(self.bus, self.channel, part)
                }
            }

            impl<R: Record> $channel<R> {
                /// Its ports.
                #[must_use]
                pub fn group(&self, config: &R::Config) -> Group {
                    Group {
                        name: self.bus,
                        channel: Some(self.channel),
                        doc: self.doc,
                        flag: VALID,
                        record: std::any::type_name::<R>().rsplit("::").next().unwrap_or_default(),
                        kind: $kind,
                        fields: fields::<R>(config),
                    }
                }
            }

            impl<R> Clone for $channel<R> {
                fn clone(&self) -> Self {
                    *self
                }
            }

            impl<R> Copy for $channel<R> {}
        )*
    };
}

channels! {
    /// A channel into a unit.
    ChannelIn, Kind::In;
    /// A channel out of a unit.
    ChannelOut, Kind::Out;
}
