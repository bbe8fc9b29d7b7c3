//! The ports of units on buses: descriptions alone, of whatever records and buses.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Error, Field, Fields, Ident, ItemStruct, LitStr, Result, Type};

use crate::annotation::{Annotations, RecordArguments};
use crate::unit::{Kind, Port, snake};

/// A field of the struct.
enum Member<'a> {
    Port(Port<'a>),
    Bus { field: &'a Ident, bus: &'a Type, name: LitStr, annotations: Annotations },
}

impl<'a> Member<'a> {
    fn of(field: &'a Field) -> Result<Self> {
        let is_port =
            |path: &syn::TypePath| path.path.segments.last().is_some_and(|last| Kind::of(&last.ident).is_ok());
        if matches!(&field.ty, Type::Path(path) if is_port(path)) {
            return Port::of(field).map(Self::Port);
        }
        let ident = field.ident.as_ref().ok_or_else(|| Error::new_spanned(field, "a unit's ports have names"))?;
        let annotations = Annotations::of(field)?;
        if annotations.documentation.is_empty() {
            return Err(Error::new_spanned(ident, "say what the bus is for"));
        }
        let name = annotations.port.clone().unwrap_or_else(|| LitStr::new(&ident.to_string(), ident.span()));
        Ok(Self::Bus { field: ident, bus: &field.ty, name, annotations })
    }

    /// Declaration and value.
    fn descriptor(&self) -> (TokenStream, TokenStream) {
        match self {
            Self::Port(port) => port.descriptor(),
            Self::Bus { field, bus, name, annotations } => {
                let docs = &annotations.documentation;
                (quote!(#(#docs)* pub #field: #bus), quote!(#field: <#bus>::on(#name)))
            }
        }
    }

    fn describe(&self) -> Result<TokenStream> {
        match self {
            Self::Port(port) => port.describe(),
            Self::Bus { bus, name, annotations, .. } => {
                let config = annotations.config();
                let describe =
                    quote!(groups.extend(::pointcore_contract::bus::Bus::groups(&<#bus>::on(#name), #config)););
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
