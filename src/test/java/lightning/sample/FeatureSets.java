package lightning.sample;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Covering arrays of {@link SceneFeature}: few sets of features, so that each two or three of them that can be in one scene are in one set.
 * Most faults of feature combinations need two features (Kuhn, Wallace, Gallo: Software Fault Interactions and Implications for Software
 * Testing, 2004).
 */
public final class FeatureSets {
    /** Features of a scene: more hide each other and make a failure hard to read; fewer need more scenes. */
    private static final int SIZE = 12;

    private FeatureSets() {}

    /**
     * Returns sets of at most 12 features, always the same. The algorithm is greedy: each set starts with the first combination that no set
     * has, and takes the feature that adds most such combinations.
     *
     * @param strength number of features that shall be together: 2 or 3
     */
    public static List<Set<SceneFeature>> covering(int strength) {
        Set<Set<SceneFeature>> missing = combinations(strength);
        List<Set<SceneFeature>> sets = new ArrayList<>();
        for (Set<SceneFeature> first : combinations(strength)) {
            if (missing.contains(first)) {
                Set<SceneFeature> set = extended(first, strength, missing);
                missing.removeIf(set::containsAll);
                sets.add(set);
            }
        }
        return sets;
    }

    private static Set<SceneFeature> extended(Set<SceneFeature> first, int strength, Set<Set<SceneFeature>> missing) {
        Set<SceneFeature> set = EnumSet.copyOf(first);
        while (set.size() < SIZE) {
            SceneFeature best = null;
            long most = -1;
            for (SceneFeature feature : SceneFeature.values()) {
                if (!set.contains(feature) && set.stream().noneMatch(feature::excludes)) {
                    long added = subsets(set, strength - 1).stream().filter(rest -> missing.contains(with(rest, feature))).count();
                    if (added > most) {
                        most = added;
                        best = feature;
                    }
                }
            }
            set.add(best);
        }
        return set;
    }

    /** Returns all sets of so many features that a scene can have together, in the order of the features. */
    static Set<Set<SceneFeature>> combinations(int strength) {
        List<Set<SceneFeature>> all = subsets(EnumSet.allOf(SceneFeature.class), strength);
        all.removeIf(set -> set.stream().anyMatch(one -> set.stream().anyMatch(one::excludes)));
        return new LinkedHashSet<>(all);
    }

    private static List<Set<SceneFeature>> subsets(Set<SceneFeature> features, int size) {
        List<Set<SceneFeature>> subsets = new ArrayList<>();
        if (size == 0) {
            subsets.add(EnumSet.noneOf(SceneFeature.class));
            return subsets;
        }
        for (SceneFeature feature : features) {
            Set<SceneFeature> later = EnumSet.copyOf(features);
            later.removeIf(other -> other.compareTo(feature) <= 0);
            subsets(later, size - 1).forEach(rest -> subsets.add(with(rest, feature)));
        }
        return subsets;
    }

    private static Set<SceneFeature> with(Set<SceneFeature> set, SceneFeature feature) {
        Set<SceneFeature> result = EnumSet.copyOf(set);
        result.add(feature);
        return result;
    }
}
