package lightning.editor.window.command;

import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.document.look.Lighting;
import lightning.document.look.LookFiles;
import lightning.editor.Command;
import lightning.editor.window.model.ComparedLooks;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.render.relight.SceneView;
import lightning.scene.Scene;

/** Saves the looks before and after a review with the scene, and shows both beside each other in the panel of looks. */
record ReviewedLooks(EditorModel model) {
    private static final int MAX_NAME = 30;

    /**
     * Saves both looks in the background.
     *
     * @param cache    cache of a finished picture of the scene
     * @param before   scene before the review
     * @param after    scene of the review
     * @param reviewer name that a reviewer entered
     */
    void save(PixelCache cache, Scene before, Scene after, String reviewer) {
        LookFiles folder = model.editor().looksFolder();
        String name = fileName(reviewer);
        model.files().runInOrder(() -> {
            String first = free(folder, Messages.tr("Before the review of {0}", name));
            String second = free(folder, Messages.tr("Review of {0}", name));
            try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
                renderer.restore(cache);
                folder.save(first, Lighting.of(before), picture(renderer, before), view(before));
                folder.save(second, Lighting.of(after), picture(renderer, after), view(after));
            }
            return new ComparedLooks(first, second);
        }, looks -> {
            model.editor().compareLooks(looks);
            var panels = model.layout().panelsProperty();
            panels.set(panels.get().open(Command.LOOKS));
        }, failure -> model.editor().message().show(ErrorMessage.of(failure)));
    }

    private static Film picture(Renderer renderer, Scene scene) {
        renderer.render(scene, Progress.NONE);
        return renderer.film();
    }

    private static ViewTransform view(Scene scene) {
        return SceneView.of(scene).forOutput();
    }

    /** Returns a text without the characters that file names cannot have. */
    private static String fileName(String text) {
        String allowed = text.replaceAll("[/\\\\:*?\"<>|\\p{Cntrl}]", "_");
        return allowed.substring(0, Math.min(allowed.length(), MAX_NAME)).replaceAll("[ .]+$", "");
    }

    private static String free(LookFiles folder, String name) {
        String free = name;
        for (int i = 2; folder.has(free); i++) {
            free = name + " " + i;
        }
        return free;
    }
}
