//! What stands in the attributes of structs and fields.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Expr, Field, Ident, LitStr, Meta, Result, Token, Type};

/// `config: Config`.
pub struct RecordArguments {
    pub binding: Ident,
    pub config: Type,
}

impl Parse for RecordArguments {
    fn parse(input: ParseStream) -> Result<Self> {
        let binding = input.parse()?;
        input.parse::<Token![:]>()?;
        Ok(Self { binding, config: input.parse()? })
    }
}

/// `search_sieve, config: Config`.
pub struct UnitArguments {
    pub module: Ident,
    pub record: RecordArguments,
}

impl Parse for UnitArguments {
    fn parse(input: ParseStream) -> Result<Self> {
        let module = input.parse()?;
        input.parse::<Token![,]>()?;
        Ok(Self { module, record: input.parse()? })
    }
}

/// The attributes of a field, or of a whole unit.
#[derive(Default)]
pub struct Annotations {
    pub documentation: Vec<Attribute>,
    pub bits: Option<Expr>,
    pub below: Option<Expr>,
    pub count: Option<Expr>,
    pub name: Option<Expr>,
    pub when: Option<Expr>,
    pub port: Option<LitStr>,
    pub flag: Option<LitStr>,
    pub with: Option<Expr>,
}

impl Annotations {
    pub fn of(field: &Field) -> Result<Self> {
        Self::parse(&field.attrs)
    }

    pub fn parse(attributes: &[Attribute]) -> Result<Self> {
        let mut found = Self::default();
        for attribute in attributes {
            let Some(name) = attribute.path().get_ident() else { continue };
            match name.to_string().as_str() {
                "doc" => found.documentation.push(attribute.clone()),
                "bits" => found.bits = Some(attribute.parse_args()?),
                "below" => found.below = Some(attribute.parse_args()?),
                "count" => found.count = Some(attribute.parse_args()?),
                "name" => found.name = Some(attribute.parse_args()?),
                "when" => found.when = Some(attribute.parse_args()?),
                "port" => found.port = Some(attribute.parse_args()?),
                "with" => found.with = Some(attribute.parse_args()?),
                "flag" => found.flag = Some(attribute.parse_args()?),
                _ => {
                    return Err(syn::Error::new(
                        name.span(),
                        "expected doc, bits, below, count, name, when, port, flag or with",
                    ));
                }
            }
        }
        Ok(found)
    }

    /// What a port's record depends on, as a reference: the unit's `config` unless something else is said.
    pub fn config(&self) -> TokenStream {
        self.with.as_ref().map_or(quote!(config), |with| quote!(#with))
    }

    /// The doc comment as one line.
    pub fn text(&self) -> String {
        let line = |attribute: &Attribute| match &attribute.meta {
            Meta::NameValue(pair) => match &pair.value {
                Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value().trim().to_owned()),
                _ => None,
            },
            _ => None,
        };
        self.documentation.iter().filter_map(line).collect::<Vec<_>>().join(" ").trim().to_owned()
    }
}
