/** {@link lightning.render.engine.lanes.LaneEngine}: rays in packets, the lighting equation in vector lanes. */
package lightning.render.engine.lanes;
