/** Vectorized implementation, {@link lightning.render.engine.lanes.LaneEngine}: rays in packets, lighting equation in lanes. */
@NullMarked
package lightning.render.engine.lanes;

import org.jspecify.annotations.NullMarked;
