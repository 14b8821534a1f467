/**
 * The parts that only the paper's own modes of 1998 use: updates that scale stored contributions by ratios, with a bound of their error,
 * and lists of hits for mirrors on demand. Other packages reach the updates through {@link lightning.render.relight.plan.UpdateMethod}.
 */
package lightning.render.relight.paper;
