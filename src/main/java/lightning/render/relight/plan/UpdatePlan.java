package lightning.render.relight.plan;

import java.util.List;
import lightning.base.text.Messages;
import lightning.render.trace.ShapeChange;
import org.jspecify.annotations.Nullable;

/** Plan of a renderer's update from the scene rendered last to the target scene. */
public sealed interface UpdatePlan {

    /** No update: the picture is current. */
    record Nothing() implements UpdatePlan {}

    /** Full trace that fills the cache: no picture yet, or camera, size or geometry changed. */
    record FirstPass(String reason) implements UpdatePlan {}

    /**
     * Update of the cache.
     *
     * @param top       plan of the first level
     * @param mirrors   plan of the mirror levels, or null if they stay unchanged
     * @param oldDepth  cached recursion depth
     * @param newDepth  target recursion depth
     * @param resampled true if pixels get other finer samples, or none, regardless of the edges
     * @param shapes    change of the shapes; if there is one, {@code mirrors} is not null
     * @param paths     update of the paths of indirect light
     */
    record Relight(LevelPlan top, @Nullable LevelPlan mirrors, int oldDepth, int newDepth, boolean resampled, ShapeChange shapes,
            PathUpdate paths)
            implements UpdatePlan {

        /** Creates an update with unchanged shapes, in which edges determine the finer samples. */
        public Relight(LevelPlan top, @Nullable LevelPlan mirrors, int oldDepth, int newDepth, PathUpdate paths) {
            this(top, mirrors, oldDepth, newDepth, false, ShapeChange.NONE, paths);
        }
    }

    /** Returns the plan in the terms of the paper, one step per string. */
    default List<String> steps() {
        return switch (this) {
            case Nothing _ -> List.of(Messages.tr("nothing to do"));
            case FirstPass first -> List.of(Messages.tr("full render: {0}", Messages.tr(first.reason())));
            case Relight relight -> PlanDescription.steps(relight);
        };
    }

    /** Returns the steps on one line. */
    default String description() {
        return String.join(", ", steps());
    }
}
