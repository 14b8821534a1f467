/**
 * What an edit asks for: the difference of two scenes, in the paper's terms, and the least update that answers it. Plans are
 * values; nothing here writes a tile.
 *
 * <p>{@link lightning.render.relight.plan.Dispatcher} makes an {@link lightning.render.relight.plan.UpdatePlan}: for each level a
 * {@link lightning.render.relight.plan.LevelPlan}, for each light a {@link lightning.render.relight.plan.LightUpdate}. How it is carried out
 * is the affair of an {@link lightning.render.relight.plan.UpdateMethod}.
 */
package lightning.render.relight.plan;
