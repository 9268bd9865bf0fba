// A type in no namespace at all.
#pragma once

struct Global {};
