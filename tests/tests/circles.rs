//! No circle between the files of a crate, and none between its folders: what one needs, however indirectly, does
//! not need it.
//!
//! A file needs another where it names something the other defines, also through a `pub use`. Words of macros and
//! what is there for tests alone do not count, and methods do not show: `impl` blocks may lie in a file of their own.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use syn::visit::Visit;
use syn::{
    Attribute, Expr, ExprLit, Item, ItemMod, ItemUse, Lit, Meta, MetaNameValue, UseTree, Visibility,
};

/// Path of a module from the root of its crate.
type Module = Vec<String>;

/// The files of a crate and what they name.
#[derive(Default)]
struct Crate {
    /// File that each module lies in.
    files: BTreeMap<Module, PathBuf>,
    /// Items a module gives out that lie elsewhere: their name there, and where they are.
    given_out: BTreeMap<(Module, String), Module>,
    /// Names in each module, from the root of the crate.
    named: BTreeSet<(Module, Module)>,
}

impl Crate {
    /// Reads all modules below `file` from `source`.
    fn read(file: &Path, source: &dyn Fn(&Path) -> Option<String>) -> Self {
        let mut read = Self::default();
        read.file(file, file, Module::new(), source);
        read
    }

    fn file(
        &mut self,
        root: &Path,
        file: &Path,
        module: Module,
        source: &dyn Fn(&Path) -> Option<String>,
    ) {
        let text = source(file).unwrap_or_else(|| panic!("{} is missing", file.display()));
        let parsed = syn::parse_file(&text).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
        let mut names = Names {
            module,
            file,
            of: self,
            inside: modules_of(&parsed.items),
            children: Vec::new(),
        };
        parsed.items.iter().for_each(|item| names.visit_item(item));
        let (module, children) = (names.module, names.children);
        self.files.insert(module.clone(), file.to_owned());
        let has_folder = file == root || file.ends_with("mod.rs");
        let folder = match has_folder {
            true => file.with_file_name(""),
            false => file.with_extension(""),
        };
        for (child, path) in children {
            let candidates = match path {
                Some(path) => vec![file.with_file_name(path)],
                None => vec![
                    folder.join(format!("{child}.rs")),
                    folder.join(&child).join("mod.rs"),
                ],
            };
            let found = candidates.iter().find(|file| source(file).is_some());
            let found = found.unwrap_or_else(|| panic!("no file of {child} in {}", file.display()));
            let mut module = module.clone();
            module.push(child);
            self.file(root, found, module, source);
        }
    }

    /// The file in which what has this name is defined.
    fn defines(&self, name: &[String], depth: u32) -> Option<&PathBuf> {
        let at = (0..=name.len()).rev();
        let known = at.map(|length| name.split_at(length));
        let (module, rest) = known
            .map(|(module, rest)| (module.to_vec(), rest))
            .find(|(module, _)| self.files.contains_key(module))?;
        let elsewhere = rest
            .first()
            .and_then(|first| self.given_out.get(&(module.clone(), first.clone())));
        elsewhere
            .filter(|_| depth < 8)
            .and_then(|elsewhere| self.defines(elsewhere, depth + 1))
            .or_else(|| self.files.get(&module))
    }

    /// Every file with those it needs.
    fn needs(&self) -> BTreeMap<&PathBuf, BTreeSet<&PathBuf>> {
        let mut needs: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
        for (module, name) in &self.named {
            let (Some(from), Some(to)) = (self.defines(module, 8), self.defines(name, 0)) else {
                continue;
            };
            if from != to {
                needs.entry(from).or_default().insert(to);
            }
        }
        needs
    }

    /// Needs between rooms: of each two files, the file or folder of either in the folder that has both.
    fn needs_of_rooms(&self) -> BTreeMap<PathBuf, BTreeSet<PathBuf>> {
        let mut needs: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
        for (from, all) in self.needs() {
            for to in all {
                // A module's file and its folder are one room.
                let names = [from, to].map(|file| file.with_extension(""));
                let both = names[0].iter().zip(&names[1]);
                let depth = both.take_while(|(a, b)| a == b).count() + 1;
                let [from, to] = names.map(|name| name.iter().take(depth).collect());
                needs.entry(from).or_default().insert(to);
            }
        }
        needs
    }

    /// Each need that is part of a circle: between files, or where there is none, between rooms.
    fn circles(&self) -> Vec<String> {
        let own = |(from, all): (&PathBuf, BTreeSet<&PathBuf>)| {
            (from.clone(), all.into_iter().cloned().collect())
        };
        let of_files = circles(&self.needs().into_iter().map(own).collect());
        match of_files.is_empty() {
            true => circles(&self.needs_of_rooms()),
            false => of_files,
        }
    }
}

/// Each need that is part of a circle.
fn circles(needs: &BTreeMap<PathBuf, BTreeSet<PathBuf>>) -> Vec<String> {
    let reaches = |from: &PathBuf, to: &PathBuf| {
        let (mut reached, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(next) = open.pop() {
            let new = needs.get(next).into_iter().flatten();
            open.extend(new.filter(|file| reached.insert(*file)));
        }
        reached.contains(to)
    };
    let all = needs
        .iter()
        .flat_map(|(from, to)| to.iter().map(move |to| (from, to)));
    let of_circles = all.filter(|(from, to)| reaches(to, from));
    let said = of_circles.map(|(from, to)| format!("{} -> {}", from.display(), to.display()));
    said.collect()
}

/// Collects what a file names.
struct Names<'a> {
    module: Module,
    file: &'a Path,
    of: &'a mut Crate,
    /// Modules of this one, wherever they are declared in it.
    inside: Vec<String>,
    /// Modules in files of their own, with the path where one is stated.
    children: Vec<(String, Option<String>)>,
}

impl Names<'_> {
    /// A name as it is written, from the root of the crate; none of another crate.
    fn rooted(&self, written: &[String]) -> Option<Module> {
        let mut base = self.module.clone();
        let mut rest = written;
        match rest.first()?.as_str() {
            "crate" => {
                base.clear();
                rest = &rest[1..];
            }
            "super" | "self" => {
                while let Some(first @ ("super" | "self")) = rest.first().map(String::as_str) {
                    if first == "super" {
                        base.pop();
                    }
                    rest = &rest[1..];
                }
            }
            child => {
                // Only a module of this one is of this crate, and only a path leads into it.
                if !self.inside.iter().any(|name| name == child) || rest.len() < 2 {
                    return None;
                }
            }
        }
        base.extend_from_slice(rest);
        Some(base)
    }

    fn note(&mut self, written: &[String]) {
        if let Some(name) = self.rooted(written) {
            self.of.named.insert((self.module.clone(), name));
        }
    }

    fn use_tree(&mut self, tree: &UseTree, before: &mut Vec<String>, gives_out: bool) {
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.use_tree(&path.tree, before, gives_out);
                before.pop();
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.use_tree(tree, before, gives_out);
                }
            }
            UseTree::Glob(_) => self.note(before),
            UseTree::Name(_) | UseTree::Rename(_) => {
                let (name, called) = match tree {
                    UseTree::Rename(rename) => (&rename.ident, &rename.rename),
                    UseTree::Name(name) => (&name.ident, &name.ident),
                    _ => return,
                };
                let mut written = before.clone();
                if name != "self" {
                    written.push(name.to_string());
                }
                if !gives_out {
                    self.note(&written);
                } else if let Some(name) = self.rooted(&written) {
                    let key = (self.module.clone(), called.to_string());
                    self.of.given_out.insert(key, name);
                }
            }
        }
    }
}

impl<'ast> Visit<'ast> for Names<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes: &[Attribute] = match item {
            Item::Mod(item) => &item.attrs,
            Item::Use(item) => &item.attrs,
            Item::Fn(item) => &item.attrs,
            Item::Impl(item) => &item.attrs,
            _ => &[],
        };
        if !attributes.iter().any(is_for_tests) {
            syn::visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        let name = item.ident.to_string();
        let Some((_, items)) = &item.content else {
            self.children.push((name, path_of(&item.attrs)));
            return;
        };
        let outside = std::mem::replace(&mut self.inside, modules_of(items));
        let declared = self.children.len();
        self.module.push(name);
        self.of
            .files
            .insert(self.module.clone(), self.file.to_owned());
        items.iter().for_each(|item| self.visit_item(item));
        self.module.pop();
        self.inside = outside;
        assert_eq!(
            self.children.len(),
            declared,
            "a file below a module that has none"
        );
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        let gives_out = !matches!(item.vis, Visibility::Inherited);
        self.use_tree(&item.tree, &mut Vec::new(), gives_out);
    }

    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let written = path.segments.iter().map(|s| s.ident.to_string());
        let written: Vec<_> = written.collect();
        if written.len() > 1 {
            self.note(&written);
        }
        syn::visit::visit_path(self, path);
    }
}

fn modules_of(items: &[Item]) -> Vec<String> {
    let named = items.iter().filter_map(|item| match item {
        Item::Mod(module) => Some(module.ident.to_string()),
        _ => None,
    });
    named.collect()
}

fn is_for_tests(attribute: &Attribute) -> bool {
    let condition = attribute.meta.require_list();
    attribute.path().is_ident("cfg")
        && condition.is_ok_and(|list| list.tokens.to_string().contains("test"))
}

/// The file that is stated of a module, be it under a condition.
fn path_of(attributes: &[Attribute]) -> Option<String> {
    attributes
        .iter()
        .find_map(|attribute| match &attribute.meta {
            Meta::NameValue(MetaNameValue {
                path,
                value:
                    Expr::Lit(ExprLit {
                        lit: Lit::Str(text),
                        ..
                    }),
                ..
            }) if path.is_ident("path") => Some(text.value()),
            Meta::List(list) if list.path.is_ident("cfg_attr") => {
                let tokens = list.tokens.to_string();
                tokens.rsplit('"').nth(1).map(str::to_owned)
            }
            _ => None,
        })
}

/// Roots of the crates of the workspace: the libraries and programs of its members.
fn roots() -> Vec<PathBuf> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("a workspace");
    let manifest = std::fs::read_to_string(top.join("Cargo.toml")).expect("a workspace");
    let manifest: toml::Table = manifest.parse().expect("TOML");
    let members = manifest["workspace"]["members"].as_array().expect("a list");
    let members = members.iter().filter_map(|member| member.as_str());
    let roots = members
        .flat_map(|member| ["src/lib.rs", "src/main.rs"].map(|root| top.join(member).join(root)));
    roots.filter(|root| root.exists()).collect()
}

#[test]
fn no_file_or_folder_needs_one_that_needs_it() {
    let roots = roots();
    assert!(roots.len() >= 25, "{roots:?}");
    let source = |file: &Path| std::fs::read_to_string(file).ok();
    let circles: Vec<_> = roots
        .iter()
        .flat_map(|root| Crate::read(root, &source).circles())
        .collect();
    assert!(circles.is_empty(), "\n{}", circles.join("\n"));
}

/// A crate of these files.
fn planted(files: &[(&str, &str)]) -> Vec<String> {
    let source = |file: &Path| {
        let mut files = files.iter();
        let found = files.find(|(name, _)| Path::new(name) == file)?;
        Some(found.1.to_owned())
    };
    Crate::read(Path::new("lib.rs"), &source).circles()
}

#[test]
fn a_planted_circle_is_found() {
    let root = ("lib.rs", "mod a; mod b; mod c; pub use b::Late;");
    let b = ("b.rs", "pub struct Late;");
    // Three files, one of them by what the root gives out, one by a path in a function.
    let circle = [
        root,
        ("a.rs", "use super::c::Early; pub struct First(Early);"),
        ("b.rs", "use crate::a::First; pub struct Late(First);"),
        ("c.rs", "pub struct Early; fn f() { let _ = crate::Late; }"),
    ];
    assert_eq!(
        planted(&circle),
        ["a.rs -> c.rs", "b.rs -> a.rs", "c.rs -> b.rs"]
    );
    let straight = [
        root,
        ("a.rs", "use super::c::Early; pub struct First(Early);"),
        b,
        (
            "c.rs",
            "pub struct Early; #[cfg(test)] mod tests { use crate::a::First; }",
        ),
    ];
    assert_eq!(planted(&straight), [""; 0]);
    // What is given out before its module is declared.
    let late = [
        ("lib.rs", "pub use b::Late; mod a; mod b;"),
        ("a.rs", "use crate::Late; pub struct First(Late);"),
        ("b.rs", "use crate::a::First; pub struct Late(First);"),
    ];
    assert_eq!(planted(&late), ["a.rs -> b.rs", "b.rs -> a.rs"]);
    // A module and its child.
    let child = [
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", ""),
        b,
        ("c.rs", "mod d; pub struct Early(d::Part);"),
        ("c/d.rs", "use super::Early; pub struct Part;"),
    ];
    assert_eq!(planted(&child), ["c/d.rs -> c.rs", "c.rs -> c/d.rs"]);
}

#[test]
fn a_circle_of_folders_is_found_where_no_file_is_in_one() {
    let found = planted(&[
        ("lib.rs", "mod a; mod b;"),
        ("a/mod.rs", "mod early; mod late;"),
        ("a/early.rs", "pub struct Early;"),
        ("a/late.rs", "use crate::b::First; pub struct Late(First);"),
        (
            "b.rs",
            "use crate::a::early::Early; pub struct First(Early);",
        ),
    ]);
    assert_eq!(found, ["a -> b", "b -> a"]);
}
