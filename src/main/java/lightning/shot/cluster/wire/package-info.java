/**
 * Wire protocol of a cluster: a closed set of messages and their encoding. Checks every length against the received bytes and a limit
 * before allocating memory; no class is named in a message.
 */
@NullMarked
package lightning.shot.cluster.wire;

import org.jspecify.annotations.NullMarked;
