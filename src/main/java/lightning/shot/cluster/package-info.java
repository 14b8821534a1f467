/**
 * Distributed rendering of a shot. A node ({@link lightning.shot.cluster.RenderNode}) renders frames for coordinators; a coordinator uses
 * nodes as hosts of a shot ({@link lightning.shot.cluster.RemoteFrameHost}). JGroups manages membership ({@link
 * lightning.shot.cluster.TlsNetwork}); only members with the same certificate can connect.
 */
@NullMarked
package lightning.shot.cluster;

import org.jspecify.annotations.NullMarked;
