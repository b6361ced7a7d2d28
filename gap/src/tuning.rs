//! Pairs that only fit because one effect undoes the other.

use crate::engine::fit::Fit;
use crate::engine::normal::difference;
use crate::engine::problem::Problem;

/// Part of an effect that is left when its partner undoes it.
const UNDONE: f64 = 0.1;
/// Size, in standard deviations of all data, above which undoing is no accident of noise.
const LARGE: f64 = 6.0;

/// Whether two effects undo each other in some observable, to within a tenth.
///
/// Two independent causes do not have sizes so well matched: the pair imitates
/// one cause that the library lacks.
pub(crate) fn cancels(problem: &Problem, fit: &Fit) -> bool {
    let [a, b] = fit.effects.as_slice() else {
        return false;
    };
    let at = |effects: &[crate::effects::Active<'static>]| {
        problem.evaluate(effects, &fit.theta, &mut problem.memory())
    };
    let none = at(&[]);
    let (only_a, only_b) = (
        difference(problem, &none, &at(std::slice::from_ref(a))),
        difference(problem, &none, &at(std::slice::from_ref(b))),
    );
    problem
        .measured_observables()
        .filter(|(observable, _)| observable.group().is_response())
        .any(|(_, data)| {
            let (va, vb) = (&only_a[data.clone()], &only_b[data]);
            let size = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
            let (na, nb) = (size(&mut va.iter().copied()), size(&mut vb.iter().copied()));
            let sum = size(&mut va.iter().zip(vb).map(|(x, y)| x + y));
            na > LARGE && nb > LARGE && sum < UNDONE * na.min(nb)
        })
}
