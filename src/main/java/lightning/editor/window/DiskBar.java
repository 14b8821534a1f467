package lightning.editor.window;

import java.util.concurrent.Executor;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.DiskNews;
import lightning.editor.document.DiskWatch;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.Presence;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.Commands;
import lightning.editor.window.widget.Obstacle;

/**
 * A line above the canvases that is there while others have changed the open scene's file, taken it away or have it open
 * too, and offers what can be done. The file is watched on a thread of its own.
 */
final class DiskBar extends HBox implements AutoCloseable {
    private static final double GAP = 8;

    private final Workbench workbench;
    private final Commands commands;
    private final DiskWatch watch;
    private final Label text = new Label();
    private final Button reload = button(Texts.of("Reload"), "disk-reload");
    private final Obstacle reloading = new Obstacle(this, reload);
    private final Button keep = button(Texts.of("Keep Mine"), "disk-keep");
    private final Button compare = button(Texts.of("Compare…"), "disk-compare");
    private final Button read = button(Texts.of("Hide"), "disk-read");
    /** What the artist has read. */
    private DiskNews dismissed;

    /**
     * @param hops  runs tasks in turn on the window's thread
     * @param both  shows the open scene beside the file, and asks
     */
    DiskBar(Workbench workbench, Commands commands, Executor hops, Runnable both) {
        this.workbench = workbench;
        this.commands = commands;
        watch = new DiskWatch(new Presence(Folders.data().resolve("open")), DiskWatch.DEFAULT_PERIOD,
                news -> hops.execute(() -> workbench.hear(news)));
        setId("disk-bar");
        getStyleClass().add("disk-bar");
        setAlignment(Pos.CENTER_LEFT);
        setSpacing(GAP);
        text.setId("disk-news");
        text.setMinWidth(0);
        text.setMaxWidth(Double.MAX_VALUE);
        text.setWrapText(true);
        HBox.setHgrow(text, Priority.ALWAYS);
        reload.setOnAction(_ -> commands.run(Command.RELOAD));
        keep.setOnAction(_ -> {
            dismiss();
            workbench.keepAgainstNews();
        });
        compare.setOnAction(_ -> both.run());
        read.setOnAction(_ -> dismiss());
        getChildren().addAll(text, reload, keep, compare, read);
        // Every look at the document is told so, one that finds all as it was too.
        commands.situation().addListener(_ -> update());
        update();
    }

    private static Button button(String name, String id) {
        var button = new Button(name);
        button.setId(id);
        button.setMinWidth(USE_PREF_SIZE);
        return button;
    }

    /** Looks at once, as when the artist comes back from another program. */
    void look() {
        watch.look();
    }

    private void dismiss() {
        dismissed = workbench.document().news();
        update();
    }

    private void update() {
        commands.situation().get();
        OpenDocument document = workbench.document();
        watch.watch(document.file(), document.known());
        DiskNews news = document.news();
        boolean told = (news.isChanged() || news.isGone() || news.elsewhere()) && !news.equals(dismissed);
        setVisible(told);
        setManaged(told);
        text.setText(sentence(document.name(), news));
        show(reload, news.isChanged());
        show(keep, news.isChanged());
        show(compare, news.isChanged());
        show(read, !news.isChanged());
        reloading.set(commands.reason(Command.RELOAD));
    }

    private static void show(Button button, boolean shown) {
        button.setVisible(shown);
        button.setManaged(shown);
    }

    private static String sentence(String name, DiskNews news) {
        if (news.isChanged()) {
            return Texts.of("{0} was changed by another program.", name);
        }
        if (news.isGone()) {
            return Texts.of("{0} is no longer where it was; Save Scene writes it again.", name);
        }
        return news.elsewhere()
                ? Texts.of("{0} is open in another editor of yours too. Each asks before it overwrites the other's work.", name)
                : "";
    }

    @Override
    public void close() {
        watch.close();
    }
}
