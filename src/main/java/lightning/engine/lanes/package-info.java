/** {@link lightning.engine.lanes.LaneEngine}: the lighting equation in vector lanes. */
package lightning.engine.lanes;
