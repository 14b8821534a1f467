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
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;

/**
 * Entry of the command palette.
 *
 * @param command  command, or the command that the entry is a value of
 * @param title  title as in its menu
 * @param menuPath  path of its menu; empty for none
 * @param disabledReason  why it is disabled; empty if it is enabled
 * @param action  runs it
 */
record PaletteEntry(Command command, String title, String menuPath, Optional<String> disabledReason, Runnable action) {

    /** Returns the entries of a menu bar in order, followed by commands that are in no menu. */
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
        // Some menus are filled when they open.
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

    /** Returns the entries that match a query, best first; all in order for an empty query. */
    static List<PaletteEntry> matching(List<PaletteEntry> all, String query) {
        record Fit(PaletteEntry entry, int score) {}
        return all.stream().flatMap(o -> score(o, query).stream().mapToObj(score -> new Fit(o, score)))
                .sorted(Comparator.comparingInt(Fit::score).reversed()).map(Fit::entry).toList();
    }

    /** Scores an entry. Matches of the title rank above matches of menu path or help. */
    private static OptionalInt score(PaletteEntry entry, String query) {
        OptionalInt titleScore = FuzzyMatch.score(query, entry.title());
        if (titleScore.isPresent()) {
            return OptionalInt.of((entry.title().equalsIgnoreCase(query.strip()) ? 2000 : 1000) + titleScore.getAsInt());
        }
        OptionalInt pathScore = FuzzyMatch.score(query, entry.menuPath() + " " + entry.title());
        return pathScore.isPresent() || query.strip().length() < 3 ? pathScore : FuzzyMatch.containsWords(query, entry.command().help());
    }
}
