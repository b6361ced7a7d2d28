//! Parts of the program and the image, as CycloneDX 1.5: one list for each.
//!
//! Packages and their ties are cargo's own, of the build that ships: of the whole workspace for the program,
//! of the one package for the image. What only ran while building is in it as `excluded`.

use crate::python;
use crate::shell::{cargo, root, run, said};
use anyhow::{Context, Result, bail};
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A program, and where cargo says what it is made of.
pub(crate) struct Product<'a> {
    pub(crate) name: &'a str,
    /// `application` or `firmware`.
    pub(crate) kind: &'a str,
    pub(crate) package: &'a str,
    /// The target triple it is built for.
    pub(crate) target: &'a str,
    /// Built alone, not with the workspace, so that only what it asks for itself is in it.
    pub(crate) alone: bool,
    pub(crate) file: &'a Path,
}

/// Writes the list of `product` to `folder`, and has an independent reader hold it against the schema.
pub(crate) fn write(product: &Product<'_>, folder: &Path) -> Result<PathBuf> {
    let packages = Packages::of(product)?;
    let path = folder.join(format!("{}.cdx.json", product.name));
    let list = packages.list(product)?;
    fs::write(&path, serde_json::to_string_pretty(&list)? + "\n")?;
    validate(&path)?;
    Ok(path)
}

/// Packages by cargo's id, as far as the product reaches them.
struct Packages {
    described: BTreeMap<String, Value>,
    /// Sums of the lock file by name and version.
    sums: BTreeMap<(String, String), String>,
    /// Reached on the way of code that ends in the product.
    linked: BTreeSet<String>,
    /// These, and what ran to build them.
    all: BTreeSet<String>,
    ties: BTreeMap<String, Vec<Tie>>,
    root: String,
}

struct Tie {
    to: String,
    /// Its code ends in the product if that of the package does: no build script, no macro.
    links: bool,
}

impl Packages {
    fn of(product: &Product<'_>) -> Result<Self> {
        let mut ask = cargo("metadata");
        ask.args(["--format-version", "1", "--locked"]);
        let answer: Value =
            serde_json::from_str(&said(ask.args(["--filter-platform", product.target]))?)?;
        let asked_for = match product.alone {
            true => Some(asked_for(product)?),
            false => None,
        };
        let mut described = BTreeMap::new();
        for package in array(&answer["packages"]) {
            let wanted = asked_for
                .as_ref()
                .is_none_or(|set| set.contains(&name_and_version(package)));
            if wanted {
                described.insert(text(&package["id"]), package.clone());
            }
        }
        let of_product = |package: &&Value| package["name"] == product.package;
        let root = described.values().find(of_product);
        let mut packages = Self {
            root: text(&root.context("cargo does not know the package")?["id"]),
            ties: ties(&answer, &described),
            described,
            sums: sums()?,
            linked: BTreeSet::new(),
            all: BTreeSet::new(),
        };
        packages.linked = packages.reached(|tie| tie.links);
        packages.all = packages.reached(|_| true);
        Ok(packages)
    }

    fn reached(&self, follow: impl Fn(&Tie) -> bool) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        let mut next = vec![self.root.clone()];
        while let Some(id) = next.pop() {
            if found.insert(id.clone()) {
                let ties = self.ties.get(&id).into_iter().flatten();
                next.extend(ties.filter(|tie| follow(tie)).map(|tie| tie.to.clone()));
            }
        }
        found
    }

    fn list(&self, product: &Product<'_>) -> Result<Value> {
        let others = self.all.iter().filter(|id| **id != self.root);
        let mut components: Vec<Value> = others.map(|id| self.component(id)).collect();
        components.push(standard_library()?);
        let dependencies: Vec<Value> = self.all.iter().map(|id| self.dependencies(id)).collect();
        let mut itself = self.component(&self.root);
        itself["type"] = json!(product.kind);
        itself["name"] = json!(product.name);
        itself["hashes"] = sha256(&sum_of(product.file)?);
        Ok(json!({
            "bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "metadata": { "component": itself },
            "components": components, "dependencies": dependencies,
        }))
    }

    fn component(&self, id: &str) -> Value {
        let package = &self.described[id];
        let mut component = Map::new();
        let mut put = |key: &str, value: Value| component.insert(key.to_owned(), value);
        put("type", json!("library"));
        put("bom-ref", json!(name_and_version(package)));
        put("name", package["name"].clone());
        put("version", package["version"].clone());
        let linked = self.linked.contains(id);
        put("scope", json!(if linked { "required" } else { "excluded" }));
        if let Some(expression) = package["license"].as_str() {
            // As old packages write a choice.
            let expression = expression.replace('/', " OR ");
            put("licenses", json!([{ "expression": expression }]));
        }
        let key = (text(&package["name"]), text(&package["version"]));
        if let Some(sum) = self.sums.get(&key) {
            put("hashes", sha256(sum));
            put("purl", json!(format!("pkg:cargo/{}@{}", key.0, key.1)));
        } else if let Some(about) = package["description"].as_str() {
            // Ours, which may stand in the place of a published one.
            put("description", json!(about));
        }
        Value::Object(component)
    }

    fn dependencies(&self, id: &str) -> Value {
        let ties = self.ties.get(id).into_iter().flatten();
        let named: BTreeSet<String> = ties
            .map(|tie| name_and_version(&self.described[&tie.to]))
            .collect();
        json!({ "ref": name_and_version(&self.described[id]), "dependsOn": named })
    }
}

/// Packages that one package alone asks for, as cargo resolves it, by name and version.
fn asked_for(product: &Product<'_>) -> Result<BTreeSet<String>> {
    let mut ask = cargo("tree");
    ask.args(["--locked", "--edges", "normal,build", "--prefix", "none"]);
    ask.args(["--package", product.package, "--target", product.target]);
    let lines = said(ask.args(["--format", "{p}"]))?;
    let name_and_version = |line: &str| {
        let mut words = line.split(' ');
        let version = words.nth(1)?.strip_prefix('v')?;
        Some(format!("{}@{version}", line.split(' ').next()?))
    };
    Ok(lines.lines().filter_map(name_and_version).collect())
}

/// Ties of building and running between packages that are described.
fn ties(answer: &Value, described: &BTreeMap<String, Value>) -> BTreeMap<String, Vec<Tie>> {
    let mut ties = BTreeMap::new();
    for node in array(&answer["resolve"]["nodes"]) {
        let known = |tie: &&Value| described.contains_key(&text(&tie["pkg"]));
        let of_node = array(&node["deps"]).iter().filter(known).filter_map(|tie| {
            let kinds = || array(&tie["dep_kinds"]).iter().map(|kind| &kind["kind"]);
            let to = text(&tie["pkg"]);
            let is_macro = array(&described[&to]["targets"])
                .iter()
                .any(|target| target["kind"] == json!(["proc-macro"]));
            let links = kinds().any(Value::is_null) && !is_macro;
            kinds()
                .any(|kind| kind != "dev")
                .then_some(Tie { to, links })
        });
        ties.insert(text(&node["id"]), of_node.collect());
    }
    ties
}

/// SHA-256 of what was fetched, which the lock file holds every build to.
fn sums() -> Result<BTreeMap<(String, String), String>> {
    let lock: toml::Table = fs::read_to_string(root().join("Cargo.lock"))?.parse()?;
    let packages = lock.get("package").and_then(|value| value.as_array());
    let packages = packages.context("Cargo.lock names no packages")?;
    let sum = |package: &toml::Value| {
        let field = |key| Some(package.get(key)?.as_str()?.to_owned());
        Some(((field("name")?, field("version")?), field("checksum")?))
    };
    Ok(packages.iter().filter_map(sum).collect())
}

/// No package of cargo's, and in every program.
fn standard_library() -> Result<Value> {
    let said = said(Command::new("rustc").arg("--version"))?;
    let version = said.split(' ').nth(1).context("rustc says no version")?;
    Ok(json!({
        "type": "framework", "bom-ref": format!("rust-std@{version}"), "name": "rust-std",
        "version": version, "scope": "required",
        "licenses": [{ "expression": "MIT OR Apache-2.0" }],
    }))
}

/// Holds a list against CycloneDX's own schema, by its Python library.
fn validate(path: &Path) -> Result<()> {
    let Some(interpreter) = python::interpreter()? else {
        eprintln!("no Python: {} is not validated", path.display());
        return Ok(());
    };
    let program = "import sys; from cyclonedx.schema import SchemaVersion; \
        from cyclonedx.validation.json import JsonStrictValidator; \
        sys.exit(JsonStrictValidator(SchemaVersion.V1_5).validate_str(open(sys.argv[1]).read()))";
    run(Command::new(interpreter)
        .args(["-c", program])
        .arg(path)
        .current_dir(root()))
    .with_context(|| format!("{} is no CycloneDX 1.5", path.display()))
}

fn sum_of(file: &Path) -> Result<String> {
    let line = said(Command::new("sha256sum").arg(file))?;
    match line.split(' ').next() {
        Some(sum) if sum.len() == 64 => Ok(sum.to_owned()),
        _ => bail!("sha256sum says {line}"),
    }
}

fn sha256(sum: &str) -> Value {
    json!([{ "alg": "SHA-256", "content": sum }])
}

fn name_and_version(package: &Value) -> String {
    format!("{}@{}", text(&package["name"]), text(&package["version"]))
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

fn array(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}
