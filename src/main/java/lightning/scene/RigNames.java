package lightning.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;

/** The names of a rig's lights and banks, shared by all rigs that differ in their attributes alone. */
final class RigNames {
    private final List<Light> lights;
    private final List<Bank> banks;
    private final Map<String, Integer> places;
    private final Map<String, Integer> bankPlaces;
    /** A stage that has none of the names; null where none was asked. Any thread may set it: each that does is right. */
    private Stage apart;

    /**
     * @throws IllegalArgumentException if two of them have the same name
     */
    RigNames(List<Light> lights, List<Bank> banks) {
        this.lights = lights;
        this.banks = banks;
        places = HashMap.newHashMap(lights.size());
        bankPlaces = HashMap.newHashMap(banks.size());
        for (Light light : lights) {
            if (places.putIfAbsent(light.name(), places.size()) != null) {
                throw taken("light", light.name());
            }
        }
        for (Bank bank : banks) {
            if (places.containsKey(bank.name()) || bankPlaces.putIfAbsent(bank.name(), bankPlaces.size()) != null) {
                throw taken("bank", bank.name());
            }
        }
    }

    /** The place of the bank of that name, or −1. */
    int bankPlace(String name) {
        return bankPlaces.getOrDefault(name, -1);
    }

    /** The place of the light of that name, or −1. */
    int place(String name) {
        return places.getOrDefault(name, -1);
    }

    /**
     * Asks a stage for the names, unless the one asked last has the same shapes.
     *
     * @throws IllegalArgumentException if a shape or a group has the name of a light or a bank
     */
    void checkApart(Stage stage) {
        Stage known = apart;
        if (known != null && known.sharesNodesWith(stage)) {
            return;
        }
        for (Light light : lights) {
            if (stage.hasNode(light.name())) {
                throw taken("light", light.name());
            }
        }
        for (Bank bank : banks) {
            if (stage.hasNode(bank.name())) {
                throw taken("bank", bank.name());
            }
        }
        apart = stage;
    }

    private static IllegalArgumentException taken(String what, String name) {
        return new IllegalArgumentException(what + " " + Quote.of(name) + ": the name is already taken");
    }
}
