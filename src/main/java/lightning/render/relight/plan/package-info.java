/**
 * Planning of updates: the difference of two scenes in the paper's terms, and the least update for it. Plans are values; no code
 * here writes a tile.
 *
 * <p>{@link lightning.render.relight.plan.Dispatcher} creates an {@link lightning.render.relight.plan.UpdatePlan}: for each level a
 * {@link lightning.render.relight.plan.LevelPlan}, for each light a {@link lightning.render.relight.plan.LightUpdate}. An {@link
 * lightning.render.relight.plan.UpdateMethod} implements the updates.
 */
@NullMarked
package lightning.render.relight.plan;

import org.jspecify.annotations.NullMarked;
