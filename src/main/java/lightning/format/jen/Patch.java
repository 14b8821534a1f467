package lightning.format.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.scene.Attribute;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.ShotSuccession;
import lightning.scene.shot.Target;

/**
 * Brings the text of a valid scene file to an edited scene by the fewest changes.
 *
 * <p>A block and an element are the same when they have one name and one type; of those left over, a
 * block and an element at the same place in their lists (from the front or from the back) are one
 * that was renamed. Blocks whose order changed are put into each other's places.
 */
final class Patch {
    private static final int VERSION_TOKEN = 1;

    private final Source source;
    private final Tokens tokens;

    private Patch(Source source, Tokens tokens) {
        this.source = source;
        this.tokens = tokens;
    }

    /**
     * The patched text.
     *
     * @param before what {@code text} reads as: what is the same in {@code edited} is not looked at
     */
    static String apply(String text, Scene before, Scene edited) {
        var problems = new Problems();
        Tokens tokens = Lexer.tokens(text, problems);
        List<Block> blocks = Parser.file(tokens, problems);
        return new Patch(new Source("", text), tokens).scene(blocks, before, edited);
    }

    /** The text with another block of the shot, the last where there was none. */
    static String shot(String text, Scene scene, Shot shot) {
        Tokens tokens = Lexer.tokens(text, new Problems());
        var source = new Source("", text);
        String block = new ShotText(scene, source.newline()).block(shot);
        Optional<Block> old = Parser.file(tokens, new Problems()).stream().filter(b -> b.type == Blocks.SHOT).findFirst();
        if (old.isPresent()) {
            return text.substring(0, tokens.start(old.get().keyword)) + block + text.substring(tokens.end(old.get().close));
        }
        return text + (text.endsWith("\n") ? "" : source.newline()) + source.newline() + block + source.newline();
    }

    /** The text without the block of a shot, which it has. */
    static String withoutShot(String text) {
        Tokens tokens = Lexer.tokens(text, new Problems());
        var edits = new Edits(text);
        var patch = new Patch(new Source("", text), tokens);
        ofKinds(Parser.file(tokens, new Problems()), List.of(Blocks.SHOT.keyword())).forEach(shot -> patch.cut(edits, shot));
        return edits.apply(0, text.length());
    }

    /** Brings the keys to what has them now: names follow, what is gone is cut out. */
    private void shot(Edits edits, Block shot, Scene before, Scene edited) {
        var succession = new ShotSuccession(before, edited);
        for (Block child : shot.children) {
            Target now = succession.of(ShotBuilder.target(child)).orElse(null);
            if (now == null) {
                cut(edits, child);
                continue;
            }
            String head = new ShotText(edited, source.newline()).head(now);
            if (ShotText.type(edited, now) != child.type || !now.name().equals(child.name)) {
                edits.replace(start(child), tokens.end(child.nameToken), head);
            }
            List<String> known = now.attributes(edited).stream().map(Attribute::name).toList();
            child.keys.stream().filter(k -> !known.contains(k.property().name())).forEach(k -> cut(edits, k.nameToken(), k.close()));
        }
    }

    private String scene(List<Block> blocks, Scene before, Scene edited) {
        var edits = new Edits(source.text());
        single(edits, blocks, Element.of(Blocks.PICTURE, edited.picture()));
        single(edits, blocks, Element.of(Blocks.CAMERA, edited.camera()));
        single(edits, blocks, Element.of(Blocks.WORLD, edited.world()));
        List<Element> added = new ArrayList<>();
        if (!edited.materials().equals(before.materials())) {
            added.addAll(list(edits, ofKinds(blocks, List.of(Blocks.MATERIAL.keyword())),
                    edited.materials().stream().map(Element::of).toList()));
        }
        if (!edited.nodes().equals(before.nodes())) {
            added.addAll(list(edits, ofKinds(blocks, Blocks.NODES), edited.nodes().stream().map(Element::of).toList()));
        }
        added.addAll(list(edits, ofKinds(blocks, List.of(Blocks.BANK.keyword())),
                edited.rig().banks().stream().map(Element::of).toList()));
        added.addAll(list(edits, ofKinds(blocks, List.of(Blocks.LIGHT.keyword())),
                edited.lights().stream().map(Element::of).toList()));
        ofKinds(blocks, List.of(Blocks.SHOT.keyword())).forEach(shot -> shot(edits, shot, before, edited));
        var out = new StringBuilder(edits.apply(0, source.text().length()));
        for (Element element : added) {
            if (out.charAt(out.length() - 1) != '\n') {
                out.append(source.newline());
            }
            out.append(JenWriter.block(element, "", source.newline())).append(source.newline());
        }
        return out.toString();
    }

    private static List<Block> ofKinds(List<Block> blocks, List<String> keywords) {
        return blocks.stream().filter(b -> keywords.contains(b.type.keyword())).toList();
    }

    private void single(Edits edits, List<Block> blocks, Element wanted) {
        List<Block> old = ofKinds(blocks, List.of(wanted.type().keyword()));
        if (!old.isEmpty()) {
            new BlockPatch(source, tokens, edits).apply(old.getFirst(), wanted);
        } else if (!wanted.isInitial()) {
            String block = source.newline() + JenWriter.block(wanted, "", source.newline());
            int end = tokens.end(VERSION_TOKEN);
            int lineEnd = source.lineEnd(end);
            boolean lastInLine = tokens.start(VERSION_TOKEN + 1) >= lineEnd;
            edits.insert(lastInLine ? lineEnd : end, lastInLine ? block : block + source.newline());
        }
    }

    /** Patches the blocks of one list, all in one parent; returns the elements to add behind the last. */
    private List<Element> list(Edits edits, List<Block> old, List<Element> wanted) {
        Map<Element, Block> same = match(old, wanted);
        List<Block> places = same.values().stream().sorted(Comparator.comparingInt(b -> b.keyword)).toList();
        Set<Block> kept = new HashSet<>(places);
        old.stream().filter(b -> !kept.contains(b)).forEach(b -> cut(edits, b));
        List<Element> added = new ArrayList<>();
        int next = 0;
        for (Element element : wanted) {
            Block block = same.get(element);
            if (block == null) {
                added.add(element);
                continue;
            }
            Block place = places.get(next++);
            insertBefore(edits, place, added);
            added.clear();
            if (block == place) {
                patch(edits, block, element);
            } else {
                var inside = new Edits(source.text());
                patch(inside, block, element);
                edits.replace(start(place), end(place), inside.apply(start(block), end(block)));
            }
        }
        return added;
    }

    private void patch(Edits edits, Block block, Element wanted) {
        new BlockPatch(source, tokens, edits).apply(block, wanted);
        if (block.type == Blocks.GROUP) {
            append(edits, block, list(edits, block.children, wanted.children()));
        }
    }

    private static Map<Element, Block> match(List<Block> old, List<Element> wanted) {
        Map<String, Block> left = new HashMap<>();
        old.forEach(b -> left.put(b.name, b));
        Map<Element, Block> same = new IdentityHashMap<>();
        for (Element element : wanted) {
            Block block = left.get(element.name());
            if (block != null && block.type == element.type()) {
                same.put(element, left.remove(element.name()));
            }
        }
        for (int i = 0; i < wanted.size(); i++) {
            Element element = wanted.get(i);
            for (int j : new int[] {i, i + old.size() - wanted.size()}) {
                if (j >= 0 && j < old.size() && !same.containsKey(element) && old.get(j).type == element.type()
                        && left.remove(old.get(j).name, old.get(j))) {
                    same.put(element, old.get(j));
                }
            }
        }
        return same;
    }

    private void insertBefore(Edits edits, Block place, List<Element> added) {
        String indent = source.indent(start(place));
        for (Element element : added) {
            String block = JenWriter.block(element, indent, source.newline()).substring(indent.length());
            edits.insert(start(place), block + source.newline() + indent);
        }
    }

    /** Puts new children before the closing brace of a group. */
    private void append(Edits edits, Block group, List<Element> added) {
        int close = tokens.start(group.close);
        String outer = source.indent(start(group));
        boolean ownLine = source.text().substring(source.lineStart(close), close).isBlank();
        for (Element element : added) {
            String block = JenWriter.block(element, outer + "  ", source.newline());
            edits.insert(ownLine ? source.lineStart(close) : close,
                    ownLine ? block + source.newline() : source.newline() + block);
        }
        if (!added.isEmpty() && !ownLine) {
            edits.insert(close, source.newline() + outer);
        }
    }

    /** Cuts out a block, with its lines where nothing else is in them. */
    private void cut(Edits edits, Block block) {
        cut(edits, block.keyword, block.close);
    }

    /** Cuts out what stands from one token to another, likewise. */
    private void cut(Edits edits, int first, int last) {
        int start = tokens.start(first);
        int end = tokens.end(last);
        int from = source.lineStart(start);
        int to = source.lineEnd(end);
        String text = source.text();
        if (text.substring(from, start).isBlank() && text.substring(end, to).isBlank()) {
            edits.replace(from, Math.min(text.length(), to == text.length() ? to : text.indexOf('\n', to) + 1), "");
        } else {
            edits.replace(start, end, "");
        }
    }

    private int start(Block block) {
        return tokens.start(block.keyword);
    }

    private int end(Block block) {
        return tokens.end(block.close);
    }
}
