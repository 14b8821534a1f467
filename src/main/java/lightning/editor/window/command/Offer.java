package lightning.editor.window.command;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import javafx.event.Event;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import lightning.base.text.Fuzzy;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.window.model.Commands;

/**
 * One thing that the editor can do now, as the palette of commands lists it.
 *
 * @param command what it is, or what it is a value of
 * @param title   as its menu has it
 * @param place   the menu that it is in; empty where it is in none
 * @param reason  why it has nothing to do; empty where it has
 * @param action  does it
 */
record Offer(Command command, String title, String place, Optional<String> reason, Runnable action) {

    /** All that a menu bar offers, in its order, and then what stands elsewhere. */
    static List<Offer> all(MenuBar bar, Commands commands) {
        List<Offer> all = new ArrayList<>();
        bar.getMenus().forEach(menu -> collect(menu, menu.getText(), commands, all));
        Stream.of(Command.values()).filter(commands::isDone).filter(c -> all.stream().noneMatch(o -> o.command() == c))
                .map(c -> new Offer(c, c.title(commands.situation().get()), "", commands.reason(c),
                        () -> commands.run(c)))
                .forEach(all::add);
        return all;
    }

    private static void collect(Menu menu, String place, Commands commands, List<Offer> all) {
        // Some are filled when they open.
        Event.fireEvent(menu, new Event(Menu.ON_SHOWING));
        for (MenuItem item : menu.getItems()) {
            if (item instanceof Menu inner) {
                collect(inner, place + " › " + inner.getText(), commands, all);
            } else {
                CommandItems.command(item)
                        .ifPresent(c -> all.add(new Offer(c, item.getText(), place, reason(item, c, commands), item::fire)));
            }
        }
    }

    private static Optional<String> reason(MenuItem item, Command command, Commands commands) {
        return item.isDisable() ? commands.reason(command).or(() -> Optional.of(Texts.of("there is nothing to choose")))
                : Optional.empty();
    }

    /** Those that fit a few letters, the best first; all in their order for none. */
    static List<Offer> fitting(List<Offer> all, String query) {
        record Fit(Offer offer, int by) {}
        return all.stream().flatMap(o -> fit(o, query).stream().mapToObj(by -> new Fit(o, by)))
                .sorted(Comparator.comparingInt(Fit::by).reversed()).map(Fit::offer).toList();
    }

    /** What fits the title goes before what fits only with its menu or its help. */
    private static OptionalInt fit(Offer offer, String query) {
        OptionalInt title = Fuzzy.fit(query, offer.title());
        if (title.isPresent()) {
            return OptionalInt.of(1000 + title.getAsInt());
        }
        OptionalInt placed = Fuzzy.fit(query, offer.place() + " " + offer.title());
        return placed.isPresent() || query.strip().length() < 3 ? placed : Fuzzy.holds(query, offer.command().help());
    }
}
