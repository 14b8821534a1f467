package lightning.editor.window.model;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.editor.Command;

/**
 * Places of the panels: which are open, where, and which is in front of each dock. Immutable.
 *
 * @param slots all panels, in the order of their tabs
 * @param fronts panel in front of a dock; absent for docks without open panels
 */
public record PanelArrangement(List<Slot> slots, Map<PanelPlace, Command> fronts) {
    /** Arrangement with all panels closed, each at its usual place. */
    public static final PanelArrangement INITIAL = new PanelArrangement(List.of(below(Command.MIXER), below(Command.TIMELINE),
            below(Command.LOOKS), below(Command.CONTRIBUTIONS), below(Command.UPDATES_PANEL), left(Command.SCOPES),
            left(Command.HISTORY_PANEL)), Map.of());

    /**
     * State of a panel.
     *
     * @param panel command that opens it
     * @param dock its dock, also remembered while it is in a window of its own
     * @param floating true if it has a window of its own
     */
    public record Slot(Command panel, PanelPlace dock, boolean floating, boolean open) {
        /** Returns the place at which the panel opens. */
        public PanelPlace place() {
            return floating ? PanelPlace.WINDOW : dock;
        }
    }

    /** Copies the lists and keeps only fronts that are open in their dock. */
    public PanelArrangement {
        slots = List.copyOf(slots);
        Map<PanelPlace, Command> valid = new EnumMap<>(PanelPlace.class);
        for (PanelPlace dock : PanelPlace.values()) {
            List<Command> open = openIn(slots, dock);
            if (dock.isDock() && !open.isEmpty()) {
                valid.put(dock, open.contains(fronts.get(dock)) ? fronts.get(dock) : open.getFirst());
            }
        }
        fronts = Map.copyOf(valid);
    }

    private static Slot below(Command panel) {
        return new Slot(panel, PanelPlace.BELOW, false, false);
    }

    private static Slot left(Command panel) {
        return new Slot(panel, PanelPlace.LEFT, false, false);
    }

    private static List<Command> openIn(List<Slot> slots, PanelPlace place) {
        return slots.stream().filter(s -> s.open() && s.place() == place).map(Slot::panel).toList();
    }

    /** Returns the open panels at a place, in the order of their tabs. */
    public List<Command> openIn(PanelPlace place) {
        return openIn(slots, place);
    }

    /** Returns the panel in front of a dock, or empty if no panel is open there. */
    public Optional<Command> front(PanelPlace dock) {
        return Optional.ofNullable(fronts.get(dock));
    }

    /** Returns whether a panel can be docked. */
    public boolean contains(Command panel) {
        return slots.stream().anyMatch(s -> s.panel() == panel);
    }

    /** Returns the place of a panel, which need not be open. */
    public PanelPlace place(Command panel) {
        return slot(panel).place();
    }

    /** Returns the dock of a panel, to which it returns from a window of its own. */
    public PanelPlace dock(Command panel) {
        return slot(panel).dock();
    }

    /** Returns whether a panel is open and not behind another one. */
    public boolean isShown(Command panel) {
        return slot(panel).open() && (slot(panel).floating() || fronts.get(slot(panel).dock()) == panel);
    }

    private Slot slot(Command panel) {
        return slots.stream().filter(s -> s.panel() == panel).findFirst().orElseThrow();
    }

    /** Opens a panel at its place, in front of the others. */
    public PanelArrangement open(Command panel) {
        return with(panel, s -> new Slot(panel, s.dock(), s.floating(), true)).inFront(panel);
    }

    /** Closes a panel. Its neighbor in the dock comes to the front. */
    public PanelArrangement close(Command panel) {
        Slot slot = slot(panel);
        PanelArrangement closed = with(panel, s -> new Slot(panel, s.dock(), s.floating(), false));
        List<Command> before = openIn(slot.place());
        List<Command> after = closed.openIn(slot.place());
        return fronts.get(slot.place()) != panel || after.isEmpty() ? closed
                : closed.inFront(after.get(Math.min(before.indexOf(panel), after.size() - 1)));
    }

    /** Moves a panel to the end of another place and opens it. */
    public PanelArrangement move(Command panel, PanelPlace place) {
        Slot slot = slot(panel);
        List<Slot> moved = new ArrayList<>(slots);
        moved.remove(slot);
        moved.add(new Slot(panel, place.isDock() ? place : slot.dock(), !place.isDock(), true));
        return new PanelArrangement(moved, fronts).inFront(panel);
    }

    /** Brings an open panel to the front of its dock. */
    public PanelArrangement inFront(Command panel) {
        Map<PanelPlace, Command> changed = new EnumMap<>(PanelPlace.class);
        changed.putAll(fronts);
        changed.put(slot(panel).place(), panel);
        return new PanelArrangement(slots, changed);
    }

    private PanelArrangement with(Command panel, UnaryOperator<Slot> change) {
        return new PanelArrangement(slots.stream().map(s -> s.panel() == panel ? change.apply(s) : s).toList(), fronts);
    }

    /** Returns the arrangement with all panels closed. Panels in windows of their own stay there. */
    public PanelArrangement closeAll() {
        return new PanelArrangement(slots.stream().map(s -> new Slot(s.panel(), s.dock(), s.floating(), false)).toList(), Map.of());
    }

    /** Returns one line for the preferences. */
    String format() {
        return slots.stream().map(s -> s.panel().name() + ":" + s.dock().name() + (s.floating() ? ":FLOATING" : "")
                + (!s.open() ? "" : fronts.get(s.place()) == s.panel() ? ":FRONT" : ":OPEN")).collect(Collectors.joining(","));
    }

    /** Reads {@link #format}. Skips unknown panels and adds missing ones, since versions differ. */
    static PanelArrangement parse(String text) {
        List<Slot> slots = new ArrayList<>();
        Map<PanelPlace, Command> fronts = new EnumMap<>(PanelPlace.class);
        for (String entry : text.split(",")) {
            List<String> words = List.of(entry.split(":", -1));
            INITIAL.slots.stream().filter(s -> s.panel().name().equals(words.getFirst()))
                    .filter(s -> slots.stream().noneMatch(other -> other.panel() == s.panel())).forEach(s -> {
                        PanelPlace dock = Stream.of(PanelPlace.values()).filter(p -> p.isDock() && words.contains(p.name())).findFirst()
                                .orElse(s.dock());
                        boolean front = words.contains("FRONT");
                        slots.add(new Slot(s.panel(), dock, words.contains("FLOATING"), front || words.contains("OPEN")));
                        if (front) {
                            fronts.put(dock, s.panel());
                        }
                    });
        }
        INITIAL.slots.stream().filter(s -> slots.stream().noneMatch(other -> other.panel() == s.panel())).forEach(slots::add);
        return new PanelArrangement(slots, fronts);
    }
}
