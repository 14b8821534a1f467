/** {@link lightning.engine.lanes.LaneEngine}: rays in packets, the lighting equation in vector lanes. */
package lightning.engine.lanes;
