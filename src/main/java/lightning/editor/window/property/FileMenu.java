package lightning.editor.window.property;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.FileBringer;
import lightning.format.jen.FileKind;

/** Offers the files of a kind that lie beside the scene, pictures with what they show, none, and to bring one from elsewhere; what lies there is seen a moment after the menu opens. */
final class FileMenu extends MenuButton {
    /** So many are shown with a small picture. */
    private static final int SMALL = 60;

    private final Commands commands;
    private final FileBringer files;
    private final Command command;
    private final FileKind kind;
    private final Consumer<String> chosen;
    private final Runnable browse;

    /**
     * @param command what choosing one does
     * @param chosen  hears the name of the file; empty for none
     * @param browse  asks for one from elsewhere
     */
    FileMenu(Commands commands, FileBringer files, String text, Command command, FileKind kind, Consumer<String> chosen, Runnable browse) {
        super(text);
        // An underscore in a file's name is one.
        setMnemonicParsing(false);
        this.commands = commands;
        this.files = files;
        this.command = command;
        this.kind = kind;
        this.chosen = chosen;
        this.browse = browse;
        setOnShowing(_ -> fill());
        offer(List.of());
    }

    private void fill() {
        Path folder = files.folder();
        files.files().beside(() -> found(folder), this::offer, _ -> offer(List.of()));
    }

    /** A file that is offered. */
    private record Found(String name, Optional<FileThumbnail> picture) {}

    private List<Found> found(Path folder) {
        List<String> all = kind.names(folder);
        return IntStream.range(0, all.size())
                .mapToObj(i -> new Found(all.get(i), i < SMALL ? FileThumbnail.of(kind, folder, all.get(i)) : Optional.empty())).toList();
    }

    private void offer(List<Found> names) {
        List<MenuItem> items = new ArrayList<>();
        items.add(item(Texts.of("None"), ""));
        items.add(CommandItems.of(commands).value(command, Texts.of("Browse…"), browse));
        items.add(new SeparatorMenuItem());
        names.forEach(found -> {
            MenuItem item = item(found.name(), found.name());
            found.picture().ifPresent(p -> item.setGraphic(p.view()));
            items.add(item);
        });
        getItems().setAll(items);
    }

    private MenuItem item(String title, String name) {
        return CommandItems.of(commands).value(command, title, () -> chosen.accept(name));
    }
}
