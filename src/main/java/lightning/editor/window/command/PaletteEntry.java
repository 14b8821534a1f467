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
import lightning.base.text.FuzzyMatch;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.window.model.CommandRegistry;

/**
 * One thing that the editor can do now, as the palette of commands lists it.
 *
 * @param command what it is, or what it is a value of
 * @param title   as its menu has it
 * @param menuPath   the menu that it is in; empty where it is in none
 * @param disabledReason  why it has nothing to do; empty where it has
 * @param action  does it
 */
record PaletteEntry(Command command, String title, String menuPath, Optional<String> disabledReason, Runnable action) {

    /** All that a menu bar offers, in its order, and then what stands elsewhere. */
    static List<PaletteEntry> all(MenuBar bar, CommandRegistry commands) {
        List<PaletteEntry> all = new ArrayList<>();
        bar.getMenus().forEach(menu -> collect(menu, menu.getText(), commands, all));
        Stream.of(Command.values()).filter(commands::hasAction).filter(c -> all.stream().noneMatch(o -> o.command() == c))
                .map(c -> new PaletteEntry(c, c.title(commands.editorState().get()), "", commands.disabledReason(c),
                        () -> commands.run(c)))
                .forEach(all::add);
        return all;
    }

    private static void collect(Menu menu, String menuPath, CommandRegistry commands, List<PaletteEntry> all) {
        // Some are filled when they open.
        Event.fireEvent(menu, new Event(Menu.ON_SHOWING));
        for (MenuItem item : menu.getItems()) {
            if (item instanceof Menu inner) {
                collect(inner, menuPath + " › " + inner.getText(), commands, all);
            } else {
                CommandMenuItems.command(item)
                        .ifPresent(c -> all.add(new PaletteEntry(c, item.getText(), menuPath, reason(item, c, commands), item::fire)));
            }
        }
    }

    private static Optional<String> reason(MenuItem item, Command command, CommandRegistry commands) {
        return item.isDisable() ? commands.disabledReason(command).or(() -> Optional.of(Messages.tr("nothing to choose")))
                : Optional.empty();
    }

    /** Those that fit a few letters, the best first; all in their order for none. */
    static List<PaletteEntry> matching(List<PaletteEntry> all, String query) {
        record Fit(PaletteEntry offer, int by) {}
        return all.stream().flatMap(o -> score(o, query).stream().mapToObj(by -> new Fit(o, by)))
                .sorted(Comparator.comparingInt(Fit::by).reversed()).map(Fit::offer).toList();
    }

    /** What fits the title goes before what fits only with its menu or its help. */
    private static OptionalInt score(PaletteEntry entry, String query) {
        OptionalInt titleScore = FuzzyMatch.score(query, entry.title());
        if (titleScore.isPresent()) {
            return OptionalInt.of(1000 + titleScore.getAsInt());
        }
        OptionalInt pathScore = FuzzyMatch.score(query, entry.menuPath() + " " + entry.title());
        return pathScore.isPresent() || query.strip().length() < 3 ? pathScore : FuzzyMatch.containsWords(query, entry.command().help());
    }
}
