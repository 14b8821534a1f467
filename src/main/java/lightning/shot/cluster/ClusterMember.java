package lightning.shot.cluster;

import java.util.UUID;

/** Member of a cluster: one process, from joining to leaving. */
public record ClusterMember(UUID id) {}
