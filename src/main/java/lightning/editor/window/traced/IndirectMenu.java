package lightning.editor.window.traced;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;

/** Menu of the settings of indirect light. Each choice is an edit of the scene. */
public final class IndirectMenu {
    private static final List<Integer> SPACINGS = List.of(2, 4, 8, 16, 32, 64);
    private static final String ID = "indirect-";

    private final SceneEditor editor;
    private final CommandMenuItems items;

    private IndirectMenu(SceneEditor editor, CommandMenuItems items) {
        this.editor = editor;
        this.items = items;
    }

    /**
     * Creates the menu.
     *
     * @param items creates the menu's items; their ids end in {@code indirect-off}, {@code indirect-on}, {@code indirect-bounces-2} and so on
     */
    public static Menu of(SceneEditor editor, CommandMenuItems items) {
        return new IndirectMenu(editor, items).menu();
    }

    private Menu menu() {
        return items.menu(Command.INDIRECT, toggle(Messages.tr("Off"), false), toggle(Messages.tr("On"), true), new SeparatorMenuItem(),
                values(Command.INDIRECT_BOUNCES, IntStream.rangeClosed(1, IndirectSettings.MAX_BOUNCES).boxed().toList(),
                        n -> Messages.count(n, "{0} Bounce", "{0} Bounces", n), IndirectSettings::bounces, IndirectSettings::withBounces),
                values(Command.INDIRECT_RAYS, IndirectSettings.RAY_COUNTS, n -> Messages.tr("{0} Rays", n), IndirectSettings::rays,
                        IndirectSettings::withRays),
                values(Command.INDIRECT_SPACING, SPACINGS, n -> Messages.tr("{0} Pixels", n), IndirectSettings::spacing,
                        IndirectSettings::withSpacing),
                values(Command.INDIRECT_BACKGROUND, List.of(false, true), on -> on ? Messages.tr("On") : Messages.tr("Off"),
                        IndirectSettings::background, IndirectSettings::withBackground),
                new SeparatorMenuItem(), items.item(Command.COMPARE_SETTINGS));
    }

    private MenuItem toggle(String title, boolean on) {
        return items.choice(Command.INDIRECT, ID + (on ? "on" : "off"), title,
                editor.sceneProperty().map(s -> indirect(s).isPresent() == on),
                () -> edit(now -> on ? Optional.of(now.orElse(IndirectSettings.INITIAL)) : Optional.empty()));
    }

    private <V> Menu values(Command command, List<V> values, Function<V, String> title, Function<IndirectSettings, V> getter,
            BiFunction<IndirectSettings, V, IndirectSettings> setter) {
        MenuItem[] choices = values.stream().map(v -> items.choice(command, command.id() + "-" + v, title.apply(v),
                editor.sceneProperty().map(s -> indirect(s).filter(i -> getter.apply(i).equals(v)).isPresent()),
                () -> edit(now -> now.map(i -> setter.apply(i, v))))).toArray(MenuItem[]::new);
        return items.menu(command, choices);
    }

    private void edit(UnaryOperator<Optional<IndirectSettings>> change) {
        editor.editOrReport(
                scene -> EditOutcome.of(() -> scene.withPicture(scene.picture().withIndirect(change.apply(indirect(scene))))));
    }

    private static Optional<IndirectSettings> indirect(Scene scene) {
        return scene.picture().indirect();
    }
}
