use super::*;
use rayon::prelude::*;

/// The squares of some numbers, made in parallel, and on how many threads.
fn squares(threads: &Threads, count: u64) -> (Vec<u64>, usize) {
    threads.run(|| ((0..count).into_par_iter().map(|x| x * x).collect(), rayon::current_num_threads()))
}

fn expected(count: u64) -> Vec<u64> {
    (0..count).map(|x| x * x).collect()
}

#[test]
fn work_is_done_on_as_many_threads_as_are_asked_for() {
    for wanted in [1, 2, 3, 7] {
        let threads = Threads::of(wanted, 100);
        assert_eq!((threads.count(), squares(&threads, 1000)), (wanted, (expected(1000), wanted)));
        // Two pieces don't begin more than two threads; a pool that is there already may have more.
        assert!((wanted.min(2)..=wanted).contains(&Threads::of(wanted, 2).count()));
        // In a pool of this size it stays where it is.
        let pool = begin(wanted).expect("a pool of few threads");
        assert_eq!(pool.install(|| squares(&Threads::of(wanted, 100), 10).1), wanted);
        // In one of another size it goes to as many as are asked for.
        assert_eq!(pool.install(|| squares(&Threads::of(wanted + 1, 100), 10).1), wanted + 1);
    }
    assert_eq!(Threads::of(0, usize::MAX).count(), cores());
    assert_eq!(Threads::of(5, 0).count(), 1);
}

#[test]
fn a_thread_that_works_alone_shares_only_what_is_much() {
    let alone = || {
        work_alone();
        let own = thread::current().id();
        let threads = |items: usize| share(items, || (thread::current().id() == own, rayon::current_num_threads()));
        assert_eq!(threads(100), (true, 1));
        let (is_here, count) = threads(1 << 20);
        assert_eq!((is_here, count), (cores() == 1, cores()));
        // Twice is as good as once, and what is within it is shared no further.
        work_alone();
        assert_eq!(share(1 << 20, || share(1 << 20, rayon::current_num_threads)), cores());
        assert_eq!(squares(&Threads::of(1, 100), 100), (expected(100), 1));
        assert_eq!(Threads::of(1, 100).run(|| share(1 << 20, rayon::current_num_threads)), 1);
        assert_eq!(share(1 << 20, rayon::current_num_threads), cores());
    };
    thread::scope(|scope| scope.spawn(alone).join()).expect("it holds");
}

#[test]
fn pieces_are_handed_over_in_their_order() {
    for wanted in [1, 2, 4] {
        let threads = Threads::of(wanted, 100);
        let mut left = 0..1000_u32;
        let mut taken = Vec::new();
        let make = || left.next().map(|x| [x, x + 1].into_par_iter().map(|x| 2 * x).collect::<Vec<_>>());
        let done: Result<(), ()> = threads.hand_over(make, |made| {
            taken.push(made);
            Ok(())
        });
        assert_eq!(done, Ok(()));
        assert_eq!(taken, (0..1000).map(|x| vec![2 * x, 2 * x + 2]).collect::<Vec<_>>());
        // An error ends the making.
        let mut made = 0;
        let make = || {
            made += 1;
            Some(made)
        };
        assert_eq!(threads.hand_over(make, |number| if number < 10 { Ok(()) } else { Err(number) }), Err(10));
        assert!(made <= 13, "{made} were made");
    }
}

#[test]
fn there_is_room_for_some_threads_and_not_for_all() {
    assert_eq!(count_with_room(2), 2);
    let some = count_with_room(usize::MAX);
    assert!(some < usize::MAX / 2);
}
