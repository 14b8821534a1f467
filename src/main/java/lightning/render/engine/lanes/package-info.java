/** Vectorized implementation, {@link lightning.render.engine.lanes.LaneEngine}: rays in packets, lighting equation in lanes. */
package lightning.render.engine.lanes;
