package lightning.shot.cluster;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import lightning.base.text.Texts;
import lightning.shot.cluster.wire.WireException;

/** Tells once of each member whose messages cannot be used. */
final class Strangers {
    private final Network network;
    private final Consumer<String> log;
    private final Set<Member> told = ConcurrentHashMap.newKeySet();

    Strangers(Network network, Consumer<String> log) {
        this.network = network;
        this.log = log;
    }

    void tell(Member member, WireException problem) {
        tell(member, Texts.of("a message of it is none: {0}", problem.getMessage()));
    }

    void tell(Member member, String problem) {
        if (told.add(member)) {
            log.accept(Texts.of("{0} is left aside: {1}", network.name(member), problem));
        }
    }
}
