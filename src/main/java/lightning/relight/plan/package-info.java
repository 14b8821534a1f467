/**
 * What an edit asks for: the difference of two scenes, in the paper's terms, and the least update that answers it. Plans are
 * values; nothing here touches a tile.
 *
 * <p>{@link lightning.relight.plan.Dispatcher} makes an {@link lightning.relight.plan.UpdatePlan}: for each level a
 * {@link lightning.relight.plan.LevelPlan}, for each light a {@link lightning.relight.plan.LightUpdate}.
 */
package lightning.relight.plan;
