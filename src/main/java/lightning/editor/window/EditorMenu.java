package lightning.editor.window;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.Parent;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.skin.ContextMenuSkin;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.command.SizeMenu;
import lightning.editor.window.model.Arrangement.Canvases;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Precision;
import lightning.editor.window.model.Speech;
import lightning.editor.window.preview.PreviewItems;
import lightning.editor.window.traced.SamplingMenu;
import lightning.editor.window.traced.ViewItems;
import lightning.editor.window.widget.Looks;
import org.kordamp.ikonli.javafx.FontIcon;

/** Every command in a menu, with its key. */
final class EditorMenu extends MenuBar {
    /** Where a line is drawn between items. */
    private static final Command LINE = null;

    private final EditorModel model;
    private final CommandItems items;

    /** Every command that is not about a menu itself does something by now. */
    EditorMenu(EditorModel model, FileActions files) {
        this.model = model;
        items = CommandItems.ofBar(model.commands());
        Menu file = menu(Texts.of("File"), Command.NEW_SCENE, Command.LOAD_FILE, Command.RELOAD, LINE, Command.SAVE_SCENE,
                Command.SAVE_SCENE_AS,
                Command.SAVE_IMAGE,
                LINE, Command.QUIT);
        file.getItems().add(2, recent(files));
        file.getItems().add(file.getItems().size() - 2, export(files));
        Menu edit = menu(Texts.of("Edit"), Command.UNDO, Command.REDO, LINE, Command.UNDO_LIGHT, Command.REDO_LIGHT, Command.HISTORY_PANEL,
                LINE,
                Command.COPY_SETTINGS,
                Command.PASTE_SETTINGS, LINE, Command.PICK_MATERIAL);
        Menu light = menu(Texts.of("Light"), Command.ADD_LIGHT, Command.DUPLICATE_LIGHT, Command.DELETE_LIGHT, LINE, Command.NEW_BANK,
                Command.DELETE_BANK, LINE, Command.RENAME_LIGHT,
                Command.SWITCH_ON, Command.SOLO, Command.LOOK_THROUGH_LIGHT, LINE, Command.AIM, Command.PLACE_HIGHLIGHT,
                Command.PLACE_DIFFUSE, Command.PLACE_RIM, Command.PLACE_SHADOW, LINE, Command.MIXER, Command.CONTRIBUTIONS, Command.CUES,
                Command.MAKE_ANIMATION, LINE);
        Menu rig = menu(Texts.of("Light Rig"), Command.LOAD_RIG, Command.ADD_RIG, Command.SAVE_RIG);
        rig.setGraphic(new FontIcon("mdi2f-file-outline"));
        light.getItems().add(rig);
        Menu shape = menu(Texts.of("Shape"), Command.DUPLICATE_SHAPE, Command.DELETE_SHAPE, Command.RENAME_SHAPE, LINE, Command.SHOW_SHAPE);
        Menu shot = menu(Texts.of("Shot"), Command.TIMELINE, Command.FILM_STRIP, LINE, Command.NEW_SHOT, Command.DELETE_SHOT, LINE,
                Command.PLAY_SHOT,
                Command.FIRST_FRAME,
                Command.PREVIOUS_FRAME, Command.NEXT_FRAME, Command.LAST_FRAME, Command.PREVIOUS_KEY, Command.NEXT_KEY, LINE,
                Command.SET_KEY,
                Command.DELETE_KEYS, Command.LINEAR_KEYS, Command.SMOOTH_KEYS, Command.STEPPED_KEYS, LINE, Command.WAY_TO_KEYS,
                Command.KEYS_TO_WAY, LINE,
                Command.EXPORT_SHOT);
        Menu render = menu(Texts.of("Render"), Command.GO, Command.LIVE, Command.UPDATE_REFLECTIONS, Command.VERIFY, Command.CANCEL, LINE,
                Command.UPDATES_PANEL, Command.ACCURACY_PANEL, Command.EFFECTS_PANEL, LINE);
        render.getItems().addAll(accuracy(), sizes(), SamplingMenu.of(model.editor(), items));
        getMenus().setAll(file, edit, light, shape, shot, render, view(),
                menu(Texts.of("Help"), Command.PALETTE, Command.KEYS, Command.ABOUT));
    }

    /**
     * What makes each menu's lines with their looks before it is opened, a step after the other. A first opening is twice as quick then,
     * though it puts the looks on again.
     */
    Stream<Runnable> ahead() {
        return getMenus().stream().flatMap(menu -> Stream.of(() -> window(menu).ifPresent(EditorMenu::make),
                () -> window(menu).ifPresent(EditorMenu::layOut)));
    }

    /** The window of a menu, which there is once the bar has its looks. */
    private static Optional<ContextMenu> window(Menu menu) {
        return Optional.ofNullable(menu.getItems().getFirst().getParentPopup());
    }

    private static void layOut(ContextMenu menu) {
        Parent lines = menu.getScene().getRoot();
        lines.applyCss();
        lines.layout();
    }

    private static void make(ContextMenu menu) {
        Looks.dress(menu.getScene());
        if (menu.getSkin() == null) {
            menu.setSkin(new ContextMenuSkin(menu));
        }
    }

    private Menu menu(String title, Command... commands) {
        var menu = new Menu(title);
        add(menu, commands);
        return menu;
    }

    private void add(Menu menu, Command... commands) {
        for (Command command : commands) {
            menu.getItems().add(command == LINE ? new SeparatorMenuItem() : items.item(command));
        }
    }

    private Menu recent(FileActions files) {
        Menu recent = items.menu(Command.LOAD_RECENT);
        recent.setOnShowing(_ -> recent.getItems().setAll(files.recentItems()));
        recent.getItems().setAll(files.recentItems());
        return recent;
    }

    private Menu export(FileActions files) {
        Menu export = items.menu(Command.EXPORT);
        export.getItems().setAll(files.exportItems());
        return export;
    }

    private Menu view() {
        var light = new SimpleBooleanProperty(Looks.worn() == Looks.LIGHT);
        light.addListener((_, _, on) -> (on ? Looks.LIGHT : Looks.DARK).wear());
        model.commands().setSwitch(Command.LIGHT_THEME, light);
        Menu view = menu(Texts.of("View"), Command.ONLY_SELECTED, Command.SCOPES);
        view.getItems().add(
                new Menu(Texts.of("Show the Picture"), null, ViewItems.of(model.picture().viewProperty(), items).toArray(MenuItem[]::new)));
        add(view, LINE, Command.TRACED_FIT, Command.TRACED_ONE_TO_ONE, Command.TRACED_ZOOM_IN, Command.TRACED_ZOOM_OUT, Command.REGION,
                LINE, Command.VIEW_X, Command.VIEW_Y, Command.VIEW_Z, Command.VIEW_ALL, LINE);
        view.getItems().addAll(PreviewItems.of(model.previewLook(), items));
        view.getItems().addAll(new SeparatorMenuItem(), canvases());
        add(view, Command.HIDE_PANELS, Command.FULL_SCREEN, LINE, Command.LIGHT_THEME);
        view.getItems().add(languages());
        return view;
    }

    private Menu canvases() {
        Menu menu = items.menu(Command.ARRANGEMENT);
        var chosen = model.arrangement().canvasesProperty();
        for (Canvases value : Canvases.values()) {
            menu.getItems().add(items.choice(Command.ARRANGEMENT, "canvases-" + value.name(), value.toString(), chosen.map(c -> c == value),
                    () -> chosen.set(value)));
        }
        return menu;
    }

    private Menu languages() {
        Menu menu = items.menu(Command.LANGUAGE);
        var chosen = model.speechProperty();
        for (Speech value : Speech.values()) {
            menu.getItems()
                    .add(items.choice(Command.LANGUAGE, "language-" + value.name(), value.toString(), chosen.map(c -> c == value), () -> {
                        chosen.set(value);
                        model.editor().message().show(Texts.of("The editor speaks it from its next start on"));
                    }));
        }
        return menu;
    }

    private Menu accuracy() {
        Menu menu = items.menu(Command.ACCURACY);
        var chosen = model.precisionProperty();
        for (Precision precision : Precision.values()) {
            menu.getItems().add(items.choice(Command.ACCURACY, "accuracy-" + precision.name(), precision.toString(),
                    chosen.map(p -> p == precision), () -> chosen.set(precision)));
        }
        return menu;
    }

    private Menu sizes() {
        Menu menu = items.menu(Command.PICTURE_SIZE);
        menu.getItems().setAll(List.copyOf(SizeMenu.ofPicture(model.editor(), items)));
        return menu;
    }
}
