package lightning.editor.window.model;

import java.util.Optional;
import lightning.base.text.Messages;
import lightning.document.PictureArea;

/** Size in which the picture is traced while the scene is edited. The scene's own size is that of exported images. */
public enum WorkingSize {
    PANE(Messages.key("Working Size: Pane"), 1), HALF_PANE(Messages.key("Working Size: Half the Pane"), 0.5),
    SCENE(Messages.key("Working Size: Scene"), 0);

    private final String title;
    private final double share;

    WorkingSize(String title, double share) {
        this.title = title;
        this.share = share;
    }

    /** Returns the stored size; that of the pane by default. */
    public static WorkingSize of(Preferences preferences) {
        return preferences.enumValue("working-size", PANE);
    }

    /** Returns the area for which pictures in a pane are traced; empty for the scene's own size. */
    public Optional<PictureArea> area(PictureArea pane) {
        return share == 0 ? Optional.empty() : Optional.of(pane.part(share));
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
