/**
 * Frames of a shot on other machines. A node ({@link lightning.shot.cluster.RenderNode}) holds frames for whoever asks; a coordinator gives them to nodes
 * as keepers of a shot ({@link lightning.shot.cluster.RemoteFrameHost}). Who is there, JGroups finds out ({@link lightning.shot.cluster.TlsNetwork}), and only
 * members that have the same certificate are heard.
 */
package lightning.shot.cluster;
