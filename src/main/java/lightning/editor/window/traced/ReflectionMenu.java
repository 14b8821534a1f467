package lightning.editor.window.traced;

import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.PictureSettings;

/** Menu of the rays of blurred reflections. Each choice is an edit of the scene. */
public final class ReflectionMenu {
    private ReflectionMenu() {}

    /**
     * Creates the menu.
     *
     * @param items creates the menu's items; their ids end in {@code reflection-rays-16} and so on
     */
    public static Menu of(SceneEditor editor, CommandMenuItems items) {
        return items.menu(Command.REFLECTION_RAYS,
                PictureSettings.REFLECTION_RAY_COUNTS.stream().map(rays -> choice(editor, items, rays)).toArray(MenuItem[]::new));
    }

    private static MenuItem choice(SceneEditor editor, CommandMenuItems items, int rays) {
        return items.choice(Command.REFLECTION_RAYS, Command.REFLECTION_RAYS.id() + "-" + rays, Messages.tr("{0} Rays", rays),
                editor.sceneProperty().map(s -> s.picture().reflectionRays() == rays),
                () -> editor.editOrReport(scene -> EditOutcome.of(() -> scene.withPicture(scene.picture().withReflectionRays(rays)))));
    }
}
