package lightning.render.relight.plan;

import java.util.List;
import lightning.base.text.Messages;
import lightning.render.shading.BranchSums;
import lightning.render.trace.ShapeChange;

/** What a renderer will do to get from the scene rendered last to the scene wanted. */
public sealed interface UpdatePlan {

    /** Nothing: the picture is as wanted. */
    record Nothing() implements UpdatePlan {}

    /** A full trace that fills the cache: no picture yet, or camera, size or geometry changed. */
    record FirstPass(String reason) implements UpdatePlan {}

    /**
     * An update of the cache.
     *
     * @param top       the first level
     * @param mirrors   the mirror levels, or null where they stay as they are
     * @param oldDepth how many mirror bounces are known
     * @param newDepth   how many are wanted
     * @param resampled whether pixels get other finer samples, or none, whatever the edges
     * @param shapes    which shapes differ; where any does, there are {@code mirrors}
     */
    record Relight(LevelPlan top, LevelPlan mirrors, int oldDepth, int newDepth, boolean resampled, ShapeChange shapes)
            implements UpdatePlan {

        /** An update of the same shapes that leaves it to the edges which finer samples there are. */
        public Relight(LevelPlan top, LevelPlan mirrors, int oldDepth, int newDepth) {
            this(top, mirrors, oldDepth, newDepth, false, ShapeChange.NONE);
        }

        /** The same with keys of sums that may be kept, or null, for each of the two. */
        public Relight withKeys(BranchSums.Key topKey, BranchSums.Key mirrorsKey) {
            return new Relight(top.withKey(topKey), mirrors == null ? null : mirrors.withKey(mirrorsKey), oldDepth, newDepth, resampled,
                    shapes);
        }
    }

    /** The plan in the words of the paper, one step a string. */
    default List<String> steps() {
        return switch (this) {
            case Nothing _ -> List.of(Messages.tr("nothing to do"));
            case FirstPass first -> List.of(Messages.tr("full render: {0}", Messages.tr(first.reason())));
            case Relight relight -> PlanDescription.steps(relight);
        };
    }

    /** The steps on one line. */
    default String description() {
        return String.join(", ", steps());
    }
}
