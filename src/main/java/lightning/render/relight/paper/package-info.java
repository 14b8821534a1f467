/**
 * What only the paper's own modes of 1998 need: updates that scale stored contributions by ratios, with a bound of their error, and
 * lists of hits for mirrors on demand. Others see a {@link lightning.render.relight.plan.UpdateMethod}, and ask which shapes are known.
 */
package lightning.render.relight.paper;
