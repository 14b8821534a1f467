package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.text.Quote;

/**
 * The lights of a scene, in the order in which their contributions are summed, and the banks that master some of them. Immutable;
 * an edit of one light or bank shares what is known of the names of all.
 */
public final class Rig {
    /** No light at all. */
    public static final Rig DARK = Rig.of(List.of());

    private final List<Light> lights;
    private final List<Bank> banks;
    private final RigNames names;
    /** The directional lights that an environment is made of. */
    private final List<Light> sky;
    private final List<Light> acting;
    /** Whether any light is solo and on, so that the others are dark. */
    private final boolean solo;

    private Rig(List<Light> lights, List<Bank> banks, RigNames names, List<Light> sky) {
        this.lights = lights;
        this.banks = banks;
        this.names = names;
        this.sky = sky;
        List<Light> own = lights.stream().allMatch(l -> l.bank().isEmpty()) ? lights : lights.stream().map(this::acting).toList();
        acting = sky.isEmpty() ? own : Stream.concat(own.stream(), sky.stream()).toList();
        solo = acting.stream().anyMatch(l -> l.solo() && l.on());
    }

    /** Lights without banks; see {@link #of(List, List)}. */
    public static Rig of(List<Light> lights) {
        return of(lights, List.of());
    }

    /**
     * @param lights names unique among themselves and the banks'; the bank of each is one of the banks, or none
     * @param banks  names unique too
     * @throws IllegalArgumentException if a name is taken or a bank missing, or if there are more lights or banks than
     *                                  {@link Limits} allows
     */
    public static Rig of(List<Light> lights, List<Bank> banks) {
        List<Light> all = List.copyOf(lights);
        List<Bank> masters = List.copyOf(banks);
        Limits.range("the number of lights", all.size(), 0, Limits.MAX_LIGHTS);
        Limits.range("the number of banks", masters.size(), 0, Limits.MAX_BANKS);
        return new Rig(all, masters, new RigNames(all, masters), List.of());
    }

    public List<Light> lights() {
        return lights;
    }

    public List<Bank> banks() {
        return banks;
    }

    /** This rig in a world, whose environment's lights come last among those that act. */
    Rig in(World world) {
        if (world.environment().isEmpty() && sky.isEmpty()) {
            return this;
        }
        List<Light> around = world.lights(this::isTaken);
        return around.equals(sky) ? this : new Rig(lights, banks, names, around);
    }

    /**
     * The lights as their banks make them, each in none, in the same order, and behind them those of the environment: those that a picture is
     * made of.
     */
    public List<Light> actingLights() {
        return acting;
    }

    /**
     * A light as its bank makes it: itself where it is in none.
     *
     * @throws IllegalArgumentException if it is in a bank that is not here
     */
    public Light acting(Light light) {
        if (light.bank().isEmpty()) {
            return light;
        }
        return bank(light.bank()).orElseThrow(() -> new IllegalArgumentException(
                "light " + Quote.of(light.name()) + ": there is no bank " + Quote.of(light.bank()))).acting(light);
    }

    RigNames names() {
        return names;
    }

    /** The place of the light of that name, or −1. */
    public int place(String name) {
        return names.place(name);
    }

    /** The light of that name. */
    public Optional<Light> light(String name) {
        int place = place(name);
        return place < 0 ? Optional.empty() : Optional.of(lights.get(place));
    }

    /** The bank of that name. */
    public Optional<Bank> bank(String name) {
        int place = names.bankPlace(name);
        return place < 0 ? Optional.empty() : Optional.of(banks.get(place));
    }

    /** Whether a light or a bank has the name. */
    public boolean isTaken(String name) {
        return place(name) >= 0 || names.bankPlace(name) >= 0;
    }

    /** Whether a light of this rig contributes: it is on, and solo if any light is; what its bank says counts. */
    public boolean shines(Light light) {
        Light shown = acting(light);
        return shown.on() && (shown.solo() || !solo);
    }

    /**
     * This rig with the light of the same name replaced.
     *
     * @throws IllegalArgumentException if no light has that name, or if its bank is missing
     */
    public Rig with(Light light) {
        int place = place(light.name());
        if (place < 0) {
            throw new IllegalArgumentException("there is no light " + Quote.of(light.name()));
        }
        List<Light> all = new ArrayList<>(lights);
        all.set(place, light);
        return new Rig(List.copyOf(all), banks, names, sky);
    }

    /** This rig with other lights and the same banks. */
    public Rig withLights(List<Light> v) {
        return of(v, banks);
    }

    /**
     * This rig with the bank of the same name replaced.
     *
     * @throws IllegalArgumentException if no bank has that name
     */
    public Rig with(Bank bank) {
        List<Bank> all = new ArrayList<>(banks);
        all.set(bankPlace(bank.name()), bank);
        return new Rig(lights, List.copyOf(all), names, sky);
    }

    /** This rig with one bank more, the last. */
    public Rig plus(Bank bank) {
        List<Bank> all = new ArrayList<>(banks);
        all.add(bank);
        return of(lights, all);
    }

    /**
     * This rig with a bank at another place among the banks.
     *
     * @param before the bank that it stands before then; empty for the last place
     * @throws IllegalArgumentException if no bank has one of these names
     */
    public Rig withBankBefore(String bank, Optional<String> before) {
        List<Bank> all = new ArrayList<>(banks);
        Bank moved = all.get(bankPlace(bank));
        int place = before.map(this::bankPlace).orElse(all.size());
        all.add(place, moved);
        all.remove(bankPlace(bank) + (place <= bankPlace(bank) ? 1 : 0));
        return of(lights, all);
    }

    /**
     * This rig with a bank of another name; its lights follow.
     *
     * @throws IllegalArgumentException if there is no such bank, or if the new name is taken
     */
    public Rig renamed(String bank, String to) {
        List<Bank> all = new ArrayList<>(banks);
        int place = bankPlace(bank);
        all.set(place, all.get(place).withName(to));
        return of(moved(bank, to), all);
    }

    /**
     * This rig without a bank; its lights stay, in none.
     *
     * @throws IllegalArgumentException if there is no such bank
     */
    public Rig without(String bank) {
        List<Bank> all = new ArrayList<>(banks);
        all.remove(bankPlace(bank));
        return of(moved(bank, ""), all);
    }

    /** This rig with other links of all its lights. */
    Rig linked(UnaryOperator<Links> links) {
        List<Light> all = null;
        for (int i = 0; i < lights.size(); i++) {
            Light light = lights.get(i).isLinked() ? lights.get(i).linked(links) : lights.get(i);
            if (light != lights.get(i)) {
                all = all == null ? new ArrayList<>(lights) : all;
                all.set(i, light);
            }
        }
        return all == null ? this : new Rig(List.copyOf(all), banks, names, sky);
    }

    private List<Light> moved(String bank, String to) {
        return lights.stream().map(l -> l.bank().equals(bank) ? l.withBank(to) : l).toList();
    }

    private int bankPlace(String bank) {
        int place = names.bankPlace(bank);
        if (place < 0) {
            throw new IllegalArgumentException("there is no bank " + Quote.of(bank));
        }
        return place;
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Rig r && lights.equals(r.lights) && banks.equals(r.banks) && sky.equals(r.sky);
    }

    @Override
    public int hashCode() {
        return 31 * lights.hashCode() + banks.hashCode();
    }
}
