package lightning.editor.window.cue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.geometry.Orientation;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.FileThread;
import lightning.editor.document.Situation;
import lightning.editor.document.cue.Cue;
import lightning.editor.document.cue.CueFolder;
import lightning.editor.document.cue.Lighting;
import lightning.editor.document.cue.LightingBlend;
import lightning.editor.loop.Frame;
import lightning.editor.window.command.AtOnce;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.Obstacle;
import lightning.editor.window.widget.WhileSeen;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Stage;

/** The cues of the open scene: keeps how it is lit with its picture, restores, compares and blends. */
public final class CuePane extends VBox {
    private static final double PERCENT = 100;

    private final SceneEditor editor;
    private final TracedPicture picture;
    private final FileThread files;
    private final TextField name = new TextField();
    private final Obstacle cannotKeep;
    private final FlowPane gallery = new FlowPane();
    private final Label message = new Label();
    private final Button back = new Button(Texts.of("Bring Back"));
    private final CueCompare compare = new CueCompare();
    private final Slider blend = new Slider(0, PERCENT, 0);
    private final Obstacle cannotBlend;
    private final Label percent = new Label("0 %");
    private final Map<String, CueCard> cards = new LinkedHashMap<>();
    private List<Cue> cues = List.of();
    private String a = "";
    private String b = "";
    private String removed = "";
    private Object gesture;
    private boolean showing;

    /** A cue and its picture at the size of its card, or null. */
    private record Listed(Cue cue, CueCard.Small small) {}

    public CuePane(SceneEditor editor, TracedPicture picture, FileThread files) {
        this.editor = editor;
        this.picture = picture;
        this.files = files;
        setId("cues");
        getStyleClass().add("cues");
        name.setId("cue-new-name");
        name.setPromptText(Texts.of("Name of a new cue"));
        name.setAccessibleText(Texts.of("name of a new cue"));
        var keep = new Button(Texts.of("Keep Cue"));
        keep.setId("cue-keep");
        keep.getStyleClass().add("accent");
        keep.setOnAction(_ -> keep());
        keep.setMinWidth(Region.USE_PREF_SIZE);
        name.setOnAction(_ -> keep.fire());
        var around = new StackPane(keep);
        cannotKeep = new Obstacle(around, keep, Texts.of("Keep how the scene is lit now, with its picture, in a folder beside the scene"));
        message.setId("cue-message");
        message.getStyleClass().add("pane-note");
        message.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(message, Priority.ALWAYS);
        back.setId("cue-back");
        back.setVisible(false);
        back.setMinWidth(Region.USE_PREF_SIZE);
        back.setOnAction(_ -> bringBack());
        var tools = new HBox(name, around, message, back);
        tools.getStyleClass().add("mixer-tools");
        blend.setId("cue-blend");
        blend.setAccessibleText(Texts.of("blend from A to B, per cent"));
        blend.setTooltip(new Tooltip(Texts.of("Light the scene between A and B; each drag is one step to undo")));
        blend.setOnMousePressed(_ -> gesture = new Object());
        blend.setOnMouseReleased(_ -> gesture = null);
        blend.valueProperty().subscribe(v -> blendTo(v.doubleValue() / PERCENT));
        HBox.setHgrow(blend, Priority.ALWAYS);
        percent.setId("cue-percent");
        percent.setMinWidth(44);
        var slide = new HBox(new Label(Texts.of("Blend  A")), blend, new Label("B"), percent);
        slide.getStyleClass().add("mixer-tools");
        cannotBlend = new Obstacle(slide, blend);
        gallery.getStyleClass().add("cue-gallery");
        var scroll = new ScrollPane(gallery);
        scroll.setFitToWidth(true);
        scroll.getStyleClass().add("edge-to-edge");
        var parts = new SplitPane(scroll, new VBox(compare, slide));
        VBox.setVgrow(compare, Priority.ALWAYS);
        parts.setOrientation(Orientation.VERTICAL);
        parts.setDividerPositions(0.38);
        VBox.setVgrow(parts, Priority.ALWAYS);
        getChildren().addAll(tools, parts);
        choose();
        WhileSeen.follow(this, this::follow);
    }

    /** Lists the cues and follows the editor. */
    private Subscription follow() {
        return Subscription.combine(editor.documentProperty().subscribe(_ -> list()),
                editor.situationProperty().subscribe(now -> cannotKeep.set(obstacle(now))),
                AtOnce.whileFocused(this, editor, files.window()));
    }

    private static Optional<String> obstacle(Situation now) {
        return now.animating() ? Optional.of(Texts.of("an animation is open; close it first"))
                : now.frame().isEmpty() ? Optional.of(Texts.of("there is no picture yet")) : now.pendingRemark();
    }

    private CueFolder folder() {
        return new CueFolder(editor.document().file());
    }

    private <T> void file(FileThread.Work<T> work, Consumer<T> done) {
        files.inTurn(work, done, why -> say(Sentence.of(why)));
    }

    private void say(String sentence) {
        message.setText(sentence);
    }

    private void list() {
        CueFolder folder = folder();
        Stage stage = editor.scene().stage();
        file(() -> {
            List<Listed> all = new ArrayList<>();
            for (Cue cue : folder.list(stage)) {
                all.add(new Listed(cue, cue.picture().map(CueCard::small).orElse(null)));
            }
            return all;
        }, all -> {
            if (folder.path().equals(folder().path())) {
                show(all);
            }
        });
    }

    private void show(List<Listed> all) {
        cues = all.stream().map(Listed::cue).toList();
        cards.clear();
        for (Listed one : all) {
            cards.put(one.cue().name(), new CueCard(one.cue(), one.small(), new Hand()));
        }
        gallery.getChildren().setAll(cards.values());
        if (cues.isEmpty()) {
            var empty = new Label(
                    Texts.of("No cues yet. A cue keeps how the scene is lit now, with its picture, in {0}.",
                            folder().path().getFileName()));
            empty.getStyleClass().add("pane-note");
            gallery.getChildren().add(empty);
        }
        choose();
    }

    private Optional<Cue> cue(String of) {
        return cues.stream().filter(c -> c.name().equals(of)).findFirst();
    }

    private Optional<Lighting> lighting(String of) {
        return cue(of).flatMap(Cue::lighting);
    }

    private void choose() {
        cards.forEach((of, card) -> card.show(of.equals(a), of.equals(b)));
        compare.show(cue(a), cue(b));
        boolean two = lighting(a).isPresent() && lighting(b).isPresent();
        cannotBlend.set(two ? Optional.empty() : Optional.of(Texts.of("choose two cues, A and B")));
        showing = true;
        blend.setValue(0);
        percent.setText("0 %");
        showing = false;
    }

    private void keep() {
        String of = name.getText().strip();
        Optional<String> refusal = CueFolder.refusal(of).or(() -> obstacle(editor.situationProperty().get()));
        if (refusal.isPresent()) {
            say(refusal.get());
            return;
        }
        if (cue(of).isPresent()) {
            say(Texts.of("There is a cue {0} already; remove it first, or choose another name", Quote.of(of)));
            return;
        }
        CueFolder folder = folder();
        Lighting lighting = Lighting.of(editor.scene());
        Frame frame = picture.frame();
        Film film = frame.film();
        ViewTransform view = picture.viewProperty().get().withMarked(false);
        file(() -> {
            folder.keep(of, lighting, film, view);
            return of;
        }, kept -> {
            say(Texts.of("Kept {0}", Quote.of(kept)));
            name.clear();
            list();
        });
    }

    private void bringBack() {
        CueFolder folder = folder();
        String of = removed;
        file(() -> {
            folder.bringBack(of);
            return of;
        }, _ -> {
            say("");
            back.setVisible(false);
            list();
        });
    }

    /** Edits the document and shows it in the traced picture. */
    private void light(Lighting lighting, Object step) {
        editor.edit(lighting::on, step).ifPresentOrElse(this::say, () -> {
            say("");
            AtOnce.render(editor);
        });
    }

    private void blendTo(double t) {
        if (showing) {
            return;
        }
        percent.setText(Math.round(t * PERCENT) + " %");
        lighting(a).ifPresent(from -> lighting(b).ifPresent(to -> {
            try {
                light(LightingBlend.at(from, to, t), gesture);
            } catch (IllegalArgumentException e) {
                say(e.getMessage());
            }
        }));
    }

    /** What the cards ask for. */
    private final class Hand implements CueCard.Asked {
        @Override
        public void restore(Cue cue) {
            cue.lighting().ifPresent(lighting -> light(lighting, null));
        }

        @Override
        public void rename(Cue cue, String to) {
            if (to.equals(cue.name())) {
                return;
            }
            CueFolder folder = folder();
            file(() -> {
                folder.rename(cue.name(), to);
                return to;
            }, _ -> {
                a = a.equals(cue.name()) ? to : a;
                b = b.equals(cue.name()) ? to : b;
                say("");
                list();
            });
        }

        @Override
        public void remove(Cue cue) {
            CueFolder folder = folder();
            file(() -> {
                folder.remove(cue.name());
                return cue.name();
            }, gone -> {
                removed = gone;
                back.setVisible(true);
                say(Texts.of("Removed {0}", Quote.of(gone)));
                list();
            });
        }

        @Override
        public void chooseA(Cue cue) {
            a = a.equals(cue.name()) ? "" : cue.name();
            choose();
        }

        @Override
        public void chooseB(Cue cue) {
            b = b.equals(cue.name()) ? "" : cue.name();
            choose();
        }
    }
}
