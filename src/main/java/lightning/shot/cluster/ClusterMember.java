package lightning.shot.cluster;

import java.util.UUID;

/** One that takes part in a cluster, for as long as its process is a member. */
public record ClusterMember(UUID id) {}
