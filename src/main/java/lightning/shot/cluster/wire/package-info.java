/**
 * What members of a cluster say to each other: a closed set of messages and their bytes. A message is read with every length checked against
 * what arrived and against a limit before memory is asked for it; no class is ever named by bytes.
 */
package lightning.shot.cluster.wire;
