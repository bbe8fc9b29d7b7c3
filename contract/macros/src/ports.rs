//! The ports of units on buses: descriptions alone, of whatever records and buses.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Error, Field, Fields, Ident, ItemStruct, LitStr, Result, Type};

use crate::annotation::{Annotations, RecordArguments};
use crate::unit::{Kind, Port, numbered, one_of, snake};

/// A field of the struct.
enum Member<'a> {
    Port(Port<'a>),
    Bus(BusMember<'a>),
}

/// A bus, or several.
struct BusMember<'a> {
    field: &'a Ident,
    bus: &'a Type,
    name: LitStr,
    /// How many there are at most, where there may be several.
    most: Option<usize>,
    annotations: Annotations,
}

impl BusMember<'_> {
    /// What the buses are called.
    fn names(&self) -> Vec<LitStr> {
        numbered(&self.name, self.most.unwrap_or(1))
    }
}

impl<'a> Member<'a> {
    fn of(field: &'a Field) -> Result<Self> {
        let (ty, most) = one_of(&field.ty)?;
        let is_port =
            |path: &syn::TypePath| path.path.segments.last().is_some_and(|last| Kind::of(&last.ident).is_ok());
        if matches!(ty, Type::Path(path) if is_port(path)) {
            return Port::of(field).map(Self::Port);
        }
        let ident = field.ident.as_ref().ok_or_else(|| Error::new_spanned(field, "a unit's ports have names"))?;
        let annotations = Annotations::of(field)?;
        if annotations.documentation.is_empty() {
            return Err(Error::new_spanned(ident, "say what the bus is for"));
        }
        let name = annotations.port.clone().unwrap_or_else(|| LitStr::new(&ident.to_string(), ident.span()));
        if most.is_some() != annotations.count.is_some() {
            return Err(Error::new_spanned(ident, "several buses need both: [ReadMaster; 4] and #[count(…)]"));
        }
        Ok(Self::Bus(BusMember { field: ident, bus: ty, name, most, annotations }))
    }

    /// Declaration and value.
    fn descriptor(&self) -> (TokenStream, TokenStream) {
        match self {
            Self::Port(port) => port.descriptor(),
            Self::Bus(member) => {
                let BusMember { field, bus, most, annotations, .. } = member;
                let (docs, names) = (&annotations.documentation, member.names());
                match most {
                    Some(most) => {
                        (quote!(#(#docs)* pub #field: [#bus; #most]), quote!(#field: [#(<#bus>::on(#names)),*]))
                    }
                    None => (quote!(#(#docs)* pub #field: #bus), quote!(#field: #(<#bus>::on(#names))*)),
                }
            }
        }
    }

    fn describe(&self) -> Result<TokenStream> {
        match self {
            Self::Port(port) => port.describe(),
            Self::Bus(member) => {
                let BusMember { bus, annotations, .. } = member;
                let (names, config) = (member.names(), annotations.config());
                let count = annotations.count.as_ref().map_or(quote!(1), |count| quote!((#count) as usize));
                let describe = quote! {
                    for bus in [#(<#bus>::on(#names)),*].into_iter().take(#count) {
                        groups.extend(::pointcore_contract::bus::Bus::groups(&bus, #config));
                    }
                };
                Ok(match &annotations.when {
                    Some(condition) => quote!(if #condition { #describe }),
                    None => describe,
                })
            }
        }
    }
}

pub fn expand(arguments: &RecordArguments, item: &ItemStruct) -> Result<TokenStream> {
    let RecordArguments { binding, config } = arguments;
    let about = Annotations::parse(&item.attrs)?;
    let docs = &about.documentation;
    let Fields::Named(fields) = &item.fields else {
        return Err(Error::new_spanned(item, "a unit's ports have names"));
    };
    let members = fields.named.iter().map(Member::of).collect::<Result<Vec<_>>>()?;
    let place = format_ident!("{}", snake(&item.ident.to_string()), span = item.ident.span());
    let (declarations, values): (Vec<_>, Vec<_>) = members.iter().map(Member::descriptor).unzip();
    let descriptions = members.iter().map(Member::describe).collect::<Result<Vec<_>>>()?;
    let (implemented, parameters, bounds) = item.generics.split_for_impl();
    Ok(quote! {
        #(#docs)*
        pub mod #place {
            use super::*;

            /// The unit's ports, each with its record, for hardware to declare.
            #[derive(Debug)]
            pub struct Ports #implemented #bounds {
                #(#declarations),*
            }

            impl #implemented Ports #parameters #bounds {
                /// The unit's ports.
                pub const ALL: Self = Self { #(#values),* };
            }

            /// The unit's ports as a list.
            #[must_use]
            pub fn interface #implemented (config: &#config) -> ::pointcore_contract::unit::Interface #bounds {
                let #binding = config;
                let _ = #binding;
                let mut groups = ::std::vec::Vec::new();
                #(#descriptions)*
                ::pointcore_contract::unit::Interface { groups }
            }
        }
    })
}
