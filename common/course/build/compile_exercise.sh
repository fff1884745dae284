#!/bin/sh
# A student's file, with the whole command of the compiler as arguments (... -o OBJECT -c FILE): where it does not
# compile it becomes an empty object, and what the compiler said becomes OBJECT.error. Always ends with 0, so that the
# rest of the course is built.
object='' last=''
for word; do
    [ "$last" = -o ] && object=$word
    last=$word
done
if said=$("$@" 2>&1); then
    rm -f "$object.error"
    [ -z "$said" ] || printf '%s\n' "$said"
    exit 0
fi
printf '%s\n' "$said"
printf '%s\n' "$said" >"$object.error"
: >"$object.empty.cpp"
left=$#
for word; do  # the same command, with another file at its end
    shift
    left=$((left - 1))
    [ "$left" = 0 ] && word=$object.empty.cpp
    set -- "$@" "$word"
done
exec "$@"
